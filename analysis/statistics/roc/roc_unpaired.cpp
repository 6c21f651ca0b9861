#include <cmath>
#include <statistics/basics/student_t.hpp>
#include <statistics/roc/roc.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

double unit_count(const AucEstimate& estimate) {
  return static_cast<double>(estimate.clusters > 0 ? estimate.clusters
                                                   : estimate.successes + estimate.failures);
}

}  // namespace

UnpairedAucTest unpaired_auc_test(const AucEstimate& first,
                                  const AucEstimate& second,
                                  Alternative alternative,
                                  double level) {
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("AUC: level must be in (0, 1)");
  }
  UnpairedAucTest test;
  for (const AucEstimate* estimate : {&first, &second}) {
    test.conditions.insert(
        test.conditions.end(), estimate->conditions.begin(), estimate->conditions.end());
  }
  if (!first.auc || !second.auc) {
    return test;
  }
  const double difference = *first.auc - *second.auc;
  test.difference = difference;
  if (!first.variance || !second.variance) {
    return test;
  }
  const double a = *first.variance;
  const double b = *second.variance;
  test.variance = a + b;
  if (!(a + b > 0.0)) {
    test.conditions.push_back({ConditionKind::zero_variance, ConditionSeverity::warning, "", ""});
    return test;
  }
  const double standard_error = std::sqrt(a + b);
  const double degrees_of_freedom =
      (a + b) * (a + b) / (a * a / (unit_count(first) - 1.0) + b * b / (unit_count(second) - 1.0));
  test.t = difference / standard_error;
  test.degrees_of_freedom = degrees_of_freedom;
  test.p_value = t_p_value(*test.t, degrees_of_freedom, alternative);
  const double half = standard_error * t_factor(level, degrees_of_freedom);
  test.interval = Interval{difference - half, difference + half, level};
  return test;
}

}  // namespace tcert::statistics
