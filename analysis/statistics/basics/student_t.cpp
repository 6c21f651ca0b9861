#include <statistics/basics/student_t.hpp>

#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace tcert::statistics {

double t_factor(double level, double df) {
  return boost::math::quantile(
      boost::math::complement(boost::math::students_t(df), (1.0 - level) / 2.0));
}

double t_p_value(double t, double df, Alternative alternative) {
  const boost::math::students_t student(df);
  switch (alternative) {
    case Alternative::less:
      return boost::math::cdf(student, t);
    case Alternative::greater:
      return boost::math::cdf(boost::math::complement(student, t));
    case Alternative::two_sided:
      break;
  }
  return 2.0 * boost::math::cdf(boost::math::complement(student, std::abs(t)));
}

ClusterT by_student_t(double estimate, double standard_error, double df, double level) {
  ClusterT result;
  if (!std::isfinite(estimate) || !(standard_error > 0.0) || !std::isfinite(standard_error) ||
      !(df > 0.0)) {
    return result;
  }
  const double half = t_factor(level, df) * standard_error;
  result.standard_error = standard_error;
  result.df = df;
  result.p_value = t_p_value(estimate / standard_error, df, Alternative::two_sided);
  result.interval = Interval{estimate - half, estimate + half, level};
  return result;
}

ClusterT by_cluster_t(const std::optional<double>& estimate,
                      const std::optional<double>& standard_error,
                      const std::optional<double>& statistic,
                      std::size_t clusters,
                      double level) {
  if (!estimate || !standard_error || clusters < 2) {
    return {};
  }
  const double df = static_cast<double>(clusters) - 1.0;
  ClusterT result = by_student_t(*estimate, *standard_error, df, level);
  // In other units, where the estimate's own would overflow.
  result.p_value = result.interval && statistic && std::isfinite(*statistic)
                       ? std::optional(t_p_value(*statistic, df, Alternative::two_sided))
                       : std::nullopt;
  return result;
}

}  // namespace tcert::statistics
