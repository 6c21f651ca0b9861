#include "analysis/study/replay/replay_record.hpp"

#include <array>
#include <cstddef>

namespace tcert::study {

std::string_view to_string(SpeedLawKind kind) noexcept {
  constexpr std::array<std::string_view, 4> kWords{"squash", "clip", "barrier", "profile"};
  return kWords[static_cast<std::size_t>(kind)];
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
