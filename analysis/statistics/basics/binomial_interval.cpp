#include <statistics/basics/binomial_interval.hpp>

#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <statistics/basics/normal.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

void check(double successes, double trials, double level) {
  if (!(successes >= 0.0 && successes <= trials)) {
    throw std::invalid_argument("a proportion: more successes than trials");
  }
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("a proportion: level must be in (0, 1)");
  }
}

/// The proportion under which `successes` or fewer have probability `tail`.
double upper_end(double successes, double trials, double tail) {
  return successes == trials ? 1.0
                             : boost::math::ibetac_inv(successes + 1.0, trials - successes, tail);
}

double number(std::size_t count) { return static_cast<double>(count); }

}  // namespace

std::optional<Interval> clopper_pearson(std::size_t successes, std::size_t trials, double level) {
  check(number(successes), number(trials), level);
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
  return Interval{low, upper_end(number(successes), number(trials), tail), level};
}

std::optional<double> clopper_pearson_upper(std::size_t successes,
                                            std::size_t trials,
                                            double level) {
  return effective_upper(number(successes), number(trials), level);
}

std::optional<double> effective_upper(double successes, double trials, double level) {
  check(successes, trials, level);
  return trials > 0.0 ? std::optional(upper_end(successes, trials, 1.0 - level)) : std::nullopt;
}

std::optional<Interval> wilson(std::size_t successes, std::size_t trials, double level) {
  return effective_wilson(number(successes), number(trials), level);
}

std::optional<Interval> effective_wilson(double successes, double trials, double level) {
  check(successes, trials, level);
  if (!(trials > 0.0)) {
    return std::nullopt;
  }
  const double share = successes / trials;
  const double z = normal_factor(level);
  const double per_trial = z * z / trials;
  const double centre = share + 0.5 * per_trial;
  const double half = z * std::sqrt(share * (1.0 - share) / trials + 0.25 * per_trial / trials);
  const double scale = 1.0 + per_trial;
  // Rounding must not push an end of 0 or 1 outside.
  return Interval{successes == 0.0 ? 0.0 : (centre - half) / scale,
                  successes == trials ? 1.0 : (centre + half) / scale,
                  level};
}

}  // namespace tcert::statistics
