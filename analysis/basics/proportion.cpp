#include "analysis/basics/proportion.hpp"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <stdexcept>

#include "analysis/basics/normal.hpp"

namespace tcert {
namespace {

void require(std::size_t successes, std::size_t trials, double level) {
  if (trials == 0 || successes > trials || !(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("proportion: needs 0 <= successes <= trials and 0 < level < 1");
  }
}

/// The p at which as few successes or fewer have probability `tail`.
double upper(std::size_t successes, std::size_t trials, double tail) {
  if (successes == trials) {
    return 1.0;
  }
  const auto k = static_cast<double>(successes);
  return boost::math::ibetac_inv(k + 1.0, static_cast<double>(trials) - k, tail);
}

}  // namespace

Interval wilson_interval(std::size_t successes, std::size_t trials, double level) {
  require(successes, trials, level);
  const double z = normal_factor(level);
  const auto n = static_cast<double>(trials);
  const double p = static_cast<double>(successes) / n;
  const double centre = p + z * z / (2.0 * n);
  const double half = z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
  const double scale = 1.0 + z * z / n;
  // Without failures the upper end is 1, without successes the lower one 0, up to rounding.
  return {successes == 0 ? 0.0 : std::max(0.0, (centre - half) / scale),
          successes == trials ? 1.0 : std::min(1.0, (centre + half) / scale),
          level};
}

Interval clopper_pearson_interval(std::size_t successes, std::size_t trials, double level) {
  require(successes, trials, level);
  const double tail = 0.5 * (1.0 - level);
  return {1.0 - upper(trials - successes, trials, tail), upper(successes, trials, tail), level};
}

double clopper_pearson_upper(std::size_t successes, std::size_t trials, double level) {
  require(successes, trials, level);
  return upper(successes, trials, 1.0 - level);
}

}  // namespace tcert
