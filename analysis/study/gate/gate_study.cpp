#include "analysis/study/gate/gate_study.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <statistics/basics/binomial_interval.hpp>
#include <statistics/basics/normal.hpp>
#include <statistics/logistic/binomial_likelihood.hpp>
#include <utility>

namespace tcert::study {
namespace {

constexpr std::size_t kGroups = 5;
constexpr std::size_t kCurveSteps = 100;

/// Complete passes as arrays.
struct Passes {
  std::vector<double> bottleneck;
  std::vector<std::uint8_t> success;
};

std::vector<GateCalibration> calibrate(const Passes& passes, const EvenChance& even, double level) {
  std::vector<GateCalibration> groups;
  if (!even.point) {
    return groups;
  }
  const std::size_t n = passes.bottleneck.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return passes.bottleneck[a] < passes.bottleneck[b];
  });
  for (std::size_t g = 0; g < kGroups; ++g) {
    GateCalibration group;
    for (std::size_t i = g * n / kGroups; i < (g + 1) * n / kGroups; ++i) {
      const double x = passes.bottleneck[order[i]];
      ++group.passes;
      group.successes += passes.success[order[i]];
      group.mean_margin_m += x;
      group.predicted += statistics::inverse_logit(*even.intercept + *even.slope * x);
    }
    if (group.passes == 0) {
      continue;
    }
    const auto count = static_cast<double>(group.passes);
    group.mean_margin_m /= count;
    group.predicted /= count;
    group.observed = static_cast<double>(group.successes) / count;
    group.observed_interval = statistics::wilson(group.successes, group.passes, level).value();
    groups.push_back(group);
  }
  return groups;
}

std::vector<GateChance> curve_of(const Passes& passes, const EvenChance& even, double level) {
  std::vector<GateChance> curve;
  if (!even.covariance || !even.intercept_std_error || !even.slope_std_error) {
    return curve;
  }
  const auto [least, most] =
      std::minmax_element(passes.bottleneck.begin(), passes.bottleneck.end());
  const double z = statistics::normal_factor(level);
  for (std::size_t i = 0; i <= kCurveSteps; ++i) {
    const double x =
        *least + (*most - *least) * static_cast<double>(i) / static_cast<double>(kCurveSteps);
    const double logit = *even.intercept + *even.slope * x;
    const double variance = *even.intercept_std_error * *even.intercept_std_error +
                            2.0 * x * *even.covariance +
                            x * x * *even.slope_std_error * *even.slope_std_error;
    const double half = z * std::sqrt(std::max(variance, 0.0));
    curve.push_back(
        {x,
         statistics::inverse_logit(logit),
         {statistics::inverse_logit(logit - half), statistics::inverse_logit(logit + half)}});
  }
  return curve;
}

/// Of the passes in which the certificate before the gate is known and finite.
std::optional<statistics::LogisticFit> fit_both(const std::vector<GateRow>& rows, double level) {
  std::vector<const GateRow*> used;
  for (const GateRow& row : rows) {
    if (row.success && row.pass.bottleneck_m && row.pass.before_m &&
        std::isfinite(*row.pass.before_m)) {
      used.push_back(&row);
    }
  }
  if (used.empty()) {
    return std::nullopt;
  }
  const auto count = static_cast<Eigen::Index>(used.size());
  statistics::LogisticInput input;
  input.design = Eigen::MatrixXd::Ones(count, 3);
  input.successes.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const GateRow& row = *used[static_cast<std::size_t>(i)];
    input.design(i, 1) = *row.pass.bottleneck_m;
    input.design(i, 2) = *row.pass.before_m;
    input.successes[i] = *row.success ? 1.0 : 0.0;
  }
  input.columns = {"(Intercept)", "bottleneck_m", "before_m"};
  input.term_of = {0, 1, 2};
  input.terms = {"bottleneck_m", "before_m"};
  input.response = "success";
  statistics::LogisticOptions options;
  options.level = level;
  return statistics::fit_logistic(input, options);
}

}  // namespace

GateStudy gate_study(std::vector<GateRow> rows, const EvenChanceOptions& options) {
  GateStudy study;
  study.options = options;
  study.rows = std::move(rows);
  Passes passes;
  for (const GateRow& row : study.rows) {
    if (!row.success || !row.pass.bottleneck_m) {
      ++study.incomplete;
      continue;
    }
    passes.bottleneck.push_back(*row.pass.bottleneck_m);
    passes.success.push_back(*row.success ? 1 : 0);
  }
  study.even = even_chance(passes.bottleneck, passes.success, options);
  study.calibration = calibrate(passes, study.even, options.level);
  study.curve = curve_of(passes, study.even, options.level);
  study.both = fit_both(study.rows, options.level);
  return study;
}

}  // namespace tcert::study
