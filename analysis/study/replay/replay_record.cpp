#include "analysis/study/replay/replay_record.hpp"

namespace tcert::study {

std::string_view to_string(SpeedLawKind kind) noexcept {
  return kind == SpeedLawKind::squash ? "squash" : "clip";
}

std::vector<SpeedLaw> law_grid(const SpeedLaw& law,
                               const std::vector<SpeedLawKind>& kinds,
                               const std::vector<double>& betas) {
  std::vector<SpeedLaw> grid;
  for (const SpeedLawKind kind : kinds) {
    for (const double beta : betas) {
      grid.push_back(law);
      grid.back().kind = kind;
      grid.back().beta_per_m = beta;
    }
  }
  return grid;
}

}  // namespace tcert::study
