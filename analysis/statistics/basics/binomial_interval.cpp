#include <statistics/basics/binomial_interval.hpp>

#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <statistics/basics/normal.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

void check(std::size_t successes, std::size_t trials, double level) {
  if (successes > trials) {
    throw std::invalid_argument("a proportion: more successes than trials");
  }
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("a proportion: level must be in (0, 1)");
  }
}

/// The proportion under which `successes` or fewer have probability `tail`.
double upper_end(std::size_t successes, std::size_t trials, double tail) {
  if (successes == trials) {
    return 1.0;
  }
  return boost::math::ibetac_inv(
      static_cast<double>(successes) + 1.0, static_cast<double>(trials - successes), tail);
}

}  // namespace

std::optional<Interval> clopper_pearson(std::size_t successes, std::size_t trials, double level) {
  check(successes, trials, level);
  if (trials == 0) {
    return std::nullopt;
  }
  const double tail = 0.5 * (1.0 - level);
  // The lower end of successes is what the upper end of failures leaves, but without cancellation.
  const double low = successes == 0
                         ? 0.0
                         : boost::math::ibeta_inv(static_cast<double>(successes),
                                                  static_cast<double>(trials - successes) + 1.0,
                                                  tail);
  return Interval{low, upper_end(successes, trials, tail), level};
}

std::optional<double> clopper_pearson_upper(std::size_t successes,
                                            std::size_t trials,
                                            double level) {
  check(successes, trials, level);
  if (trials == 0) {
    return std::nullopt;
  }
  return upper_end(successes, trials, 1.0 - level);
}

std::optional<Interval> wilson(std::size_t successes, std::size_t trials, double level) {
  check(successes, trials, level);
  if (trials == 0) {
    return std::nullopt;
  }
  const auto n = static_cast<double>(trials);
  const double share = static_cast<double>(successes) / n;
  const double z = normal_factor(level);
  const double per_trial = z * z / n;
  const double centre = share + 0.5 * per_trial;
  const double half = z * std::sqrt(share * (1.0 - share) / n + 0.25 * per_trial / n);
  const double scale = 1.0 + per_trial;
  // Rounding must not push an end of 0 or 1 outside.
  return Interval{successes == 0 ? 0.0 : (centre - half) / scale,
                  successes == trials ? 1.0 : (centre + half) / scale,
                  level};
}

}  // namespace tcert::statistics
