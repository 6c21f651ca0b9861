#include "analysis/study/gate/even_chance.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <statistics/basics/normal.hpp>
#include <statistics/logistic/logistic.hpp>
#include <statistics/logistic/logistic_profile.hpp>
#include <statistics/logistic/logistic_refit.hpp>
#include <statistics/resampling/bootstrap.hpp>
#include <stdexcept>
#include <table/not_a_number.hpp>

#include "analysis/study/gate/profile_point.hpp"

namespace tcert::study {
namespace {

statistics::LogisticInput input_of(std::span<const double> x,
                                   std::span<const std::uint8_t> success) {
  const auto rows = static_cast<Eigen::Index>(x.size());
  statistics::LogisticInput input;
  input.design = Eigen::MatrixXd::Ones(rows, 2);
  input.successes.resize(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    input.design(i, 1) = x[static_cast<std::size_t>(i)];
    input.successes[i] = success[static_cast<std::size_t>(i)];
  }
  input.columns = {"(Intercept)", "x"};
  input.term_of = {0, 1};
  input.terms = {"x"};
  input.response = "success";
  return input;
}

/// Values: the point, and the slope that tells whether the point means anything.
statistics::Statistic point_statistic(const statistics::LogisticInput& input) {
  const auto refit = std::make_shared<const statistics::LogisticRefit>(input);
  statistics::Statistic statistic;
  statistic.rows = static_cast<std::size_t>(input.design.rows());
  statistic.values = 2;
  statistic.make_kernel = [refit]() -> statistics::StatisticKernel {
    return [refit](std::span<const std::uint32_t> multiplicity, std::span<double> values) {
      values[0] = values[1] = table::kNaN;
      const statistics::LogisticReplicate replicate = refit->fit(multiplicity);
      if (replicate.coefficients) {
        const Eigen::VectorXd of_column = refit->column_coefficients(*replicate.coefficients);
        values[0] = -of_column[0] / of_column[1];
        values[1] = of_column[1];
      }
    };
  };
  return statistic;
}

ConfidenceSet set_of(const std::optional<statistics::Interval>& interval) {
  return interval ? ConfidenceSet{ConfidenceSetKind::bounded, interval->low, interval->high}
                  : ConfidenceSet{};
}

void add_bootstrap(const statistics::LogisticInput& input,
                   const EvenChanceOptions& options,
                   EvenChance& out) {
  const statistics::BootstrapResult result =
      statistics::bootstrap(point_statistic(input),
                            statistics::ResamplingPlan::of_rows(out.rows),
                            {options.replicates, options.seed, options.analysis});
  std::size_t falling = 0;
  for (const double slope : result.replicates[1]) {
    out.failed_replicates += std::isnan(slope) ? 1 : 0;
    falling += slope <= 0.0 ? 1 : 0;
  }
  const auto known = static_cast<double>(options.replicates - out.failed_replicates);
  if (static_cast<double>(falling) > 0.5 * (1.0 - options.level) * known) {
    out.percentile.kind = out.bca.kind = ConfidenceSetKind::whole_line;
    return;
  }
  out.percentile = set_of(statistics::bootstrap_estimate(
                              result, 0, options.level, statistics::BootstrapMethod::percentile)
                              .interval);
  const statistics::BootstrapEstimate bca =
      statistics::bootstrap_estimate(result, 0, options.level);
  out.bca = set_of(bca.interval);
  out.conditions.insert(out.conditions.end(), bca.conditions.begin(), bca.conditions.end());
}

void require(std::span<const double> x,
             std::span<const std::uint8_t> success,
             const EvenChanceOptions& options) {
  if (x.size() != success.size() || !(options.level > 0.0 && options.level < 1.0)) {
    throw std::invalid_argument("even chance: one outcome a row and a level in (0, 1)");
  }
  for (const double value : x) {
    if (!std::isfinite(value)) {
      throw std::invalid_argument("even chance: x must be finite");
    }
  }
}

}  // namespace

std::string_view to_string(ConfidenceSetKind kind) noexcept {
  constexpr std::array<std::string_view, 4> kWords = {
      "unknown", "bounded", "two_rays", "whole_line"};
  return kWords[static_cast<std::size_t>(kind)];
}

bool ConfidenceSet::covers(double x) const noexcept {
  switch (kind) {
    case ConfidenceSetKind::bounded:
      return low <= x && x <= high;
    case ConfidenceSetKind::two_rays:
      return x <= low || x >= high;
    case ConfidenceSetKind::whole_line:
      return true;
    case ConfidenceSetKind::unknown:
      break;
  }
  return false;
}

ConfidenceSet fieller_set(double intercept,
                          double slope,
                          double intercept_variance,
                          double covariance,
                          double slope_variance,
                          double level) {
  // a x^2 + 2 b x + c <= 0.
  const double z = statistics::normal_factor(level);
  const double a = slope * slope - z * z * slope_variance;
  const double b = intercept * slope - z * z * covariance;
  const double c = intercept * intercept - z * z * intercept_variance;
  const double discriminant = b * b - a * c;
  if (!(discriminant > 0.0) || a == 0.0) {
    return {ConfidenceSetKind::whole_line, 0.0, 0.0};
  }
  // The larger root in size first: the other one then loses no digits.
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  const double one = q / a;
  const double other = c / q;
  return {a > 0.0 ? ConfidenceSetKind::bounded : ConfidenceSetKind::two_rays,
          std::min(one, other),
          std::max(one, other)};
}

EvenChance even_chance(std::span<const double> x,
                       std::span<const std::uint8_t> success,
                       const EvenChanceOptions& options) {
  require(x, success, options);
  EvenChance out;
  out.rows = x.size();
  for (const std::uint8_t one : success) {
    out.successes += one;
  }
  const statistics::LogisticInput input = input_of(x, success);
  statistics::LogisticOptions fit_options;
  fit_options.level = options.level;
  const statistics::LogisticFit fit = statistics::fit_logistic(input, fit_options);
  out.conditions = fit.conditions;
  if (fit.coefficients.size() != 2 || !fit.coefficients[0].estimate ||
      !fit.coefficients[1].estimate) {
    return out;
  }
  const statistics::LogisticCoefficient& slope = fit.coefficients[1];
  out.intercept = fit.coefficients[0].estimate;
  out.intercept_std_error = fit.coefficients[0].standard_error;
  out.slope = slope.estimate;
  out.slope_std_error = slope.standard_error;
  out.slope_p = slope.p_value;
  out.slope_wald = slope.interval;
  out.slope_profile = statistics::profile_intervals(input, fit_options)[1];
  out.point = -*out.intercept / *out.slope;
  const Eigen::MatrixXd& v = fit.covariance;
  out.covariance = v(0, 1);
  out.fieller = fieller_set(*out.intercept, *out.slope, v(0, 0), v(0, 1), v(1, 1), options.level);
  const double variance = v(0, 0) + 2.0 * *out.point * v(0, 1) + *out.point * *out.point * v(1, 1);
  const double scale = std::sqrt(variance) / std::abs(*out.slope);
  out.profile = profile_point_set(x, success, *out.point, *out.slope, scale, options.level);
  if (options.replicates > 0) {
    add_bootstrap(input, options, out);
  }
  return out;
}

}  // namespace tcert::study
