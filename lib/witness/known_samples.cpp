#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tcert/tick.hpp>
#include <vector>
#include <witness/known_samples.hpp>

namespace tcert::witness {
namespace {

Samples first_samples(const Samples& samples, std::size_t count) {
  const auto first = [count](const auto& values, std::size_t each) {
    const std::size_t most = std::min(values.size(), count * each);
    return std::vector(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(most));
  };
  return {samples.rays,
          first(samples.poses, 1),
          first(samples.clearances_m, samples.rays),
          first(samples.bearings_rad, samples.rays),
          first(samples.breaks, 1),
          first(samples.known_ns, 1)};
}

}  // namespace

Samples known_samples(const Samples& felt,
                      std::int64_t time_ns,
                      const Robot& robot,
                      double lost_share) {
  const auto later = std::ranges::upper_bound(felt.known_ns, time_ns);
  Samples known = first_samples(felt, static_cast<std::size_t>(later - felt.known_ns.begin()));
  drop_glitches(known, robot, lost_share);
  for (std::size_t k = 0; k < known.rays; ++k) {
    for (std::size_t i = known.size(); i-- > 0;) {
      double& clearance_m = known.clearances_m[i * known.rays + k];
      if (!std::isnan(clearance_m)) {
        clearance_m = kMissing;
        break;
      }
    }
  }
  return known;
}

}  // namespace tcert::witness
