#include "analysis/study/experiment/fingerprint.hpp"

namespace tcert::study {
namespace {

bool depends(Stage stage, Stage on) noexcept {
  const bool both_last = stage == Stage::control && on == Stage::features;
  return on <= stage && !both_last && on != Stage::drive;
}

}  // namespace

std::string fingerprint(const ParameterSet& parameters, Stage stage) {
  std::string text;
  for (const ParameterInfo& info : parameter_table()) {
    if (depends(stage, info.stage)) {
      text.append(info.key).append("=").append(info.get(parameters)).append("\n");
    }
  }
  return text;
}

}  // namespace tcert::study
