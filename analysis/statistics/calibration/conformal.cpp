#include <statistics/calibration/conformal.hpp>

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace tcert::statistics {
namespace {

void require_share(double value, const char* what) {
  if (!(value > 0.0 && value < 1.0)) {
    throw std::invalid_argument(what);
  }
}

/// Of products that are whole but for rounding.
constexpr double kWholeWithin = 1e-9;

}  // namespace

std::optional<std::size_t> conformal_rank(std::size_t units, double alpha) {
  require_share(alpha, "conformal bound: alpha must be in (0, 1)");
  const double beyond = std::floor(alpha * (static_cast<double>(units) + 1.0) + kWholeWithin);
  if (beyond < 1.0) {
    return std::nullopt;
  }
  return units + 1 - std::min(static_cast<std::size_t>(beyond), units);
}

std::size_t least_conformal_units(double alpha) {
  require_share(alpha, "conformal bound: alpha must be in (0, 1)");
  return static_cast<std::size_t>(std::max(std::ceil((1.0 - kWholeWithin) / alpha) - 1.0, 1.0));
}

double least_conformal_alpha(std::size_t units) noexcept {
  return 1.0 / (static_cast<double>(units) + 1.0);
}

std::optional<double> conformal_quantile(std::span<const double> scores, double alpha) {
  const std::optional<std::size_t> rank = conformal_rank(scores.size(), alpha);
  if (std::ranges::any_of(scores, [](double score) { return std::isnan(score); })) {
    throw std::invalid_argument("conformal bound: a score is not a number");
  }
  if (!rank || scores.empty()) {
    return std::nullopt;
  }
  std::vector<double> sorted(scores.begin(), scores.end());
  const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(*rank - 1);
  std::ranges::nth_element(sorted, at);
  return *at;
}

double conformal_coverage_quantile(std::size_t units, std::size_t rank, double p) {
  require_share(p, "conformal coverage: p must be in (0, 1)");
  return boost::math::ibeta_inv(
      static_cast<double>(rank), static_cast<double>(units + 1 - rank), p);
}

}  // namespace tcert::statistics
