#include <algorithm>
#include <statistics/roc/roc_curve.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

// A curve on the diagonal itself may come out below it by rounding.
constexpr double kAreaRounding = 1e-12;

/// Area under the line from (x0, y0) to (x1, y1), x0 <= x1, where x is in [low, high].
double clipped_area(double x0, double y0, double x1, double y1, double low, double high) {
  const double from = std::max(x0, low);
  const double to = std::min(x1, high);
  if (!(from < to)) {
    return 0.0;
  }
  const auto y_at = [&](double x) { return y0 + (y1 - y0) * ((x - x0) / (x1 - x0)); };
  const double y_from = from == x0 ? y0 : y_at(from);
  const double y_to = to == x1 ? y1 : y_at(to);
  return (to - from) * (y_from + y_to) / 2.0;
}

}  // namespace

PartialAuc partial_auc(const RocCurve& curve, double low, double high, RocFocus focus) {
  if (!(low >= 0.0 && low < high && high <= 1.0)) {
    throw std::invalid_argument("partial AUC: bounds must be 0 <= low < high <= 1");
  }
  PartialAuc result;
  if (curve.points.empty()) {
    result.conditions.push_back({ConditionKind::one_class, ConditionSeverity::error, "", ""});
    return result;
  }
  double area = 0.0;
  for (std::size_t k = 1; k < curve.points.size(); ++k) {
    const RocPoint& p = curve.points[k - 1];
    const RocPoint& q = curve.points[k];
    area +=
        focus == RocFocus::specificity
            ? clipped_area(p.specificity, p.sensitivity, q.specificity, q.sensitivity, low, high)
            : clipped_area(q.sensitivity, q.specificity, p.sensitivity, p.specificity, low, high);
  }
  result.area = area;
  const double most = high - low;
  const double by_chance = (2.0 - (low + high)) * most / 2.0;
  if (area < by_chance - kAreaRounding) {
    result.conditions.push_back(
        {ConditionKind::below_diagonal, ConditionSeverity::warning, "", ""});
  } else {
    result.corrected = (1.0 + (area - by_chance) / (most - by_chance)) / 2.0;
  }
  return result;
}

}  // namespace tcert::statistics
