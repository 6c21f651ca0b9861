#include "analysis/basics/student.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace tcert {

double student_upper_quantile(double tail, double degrees_of_freedom) {
  return boost::math::quantile(
      boost::math::complement(boost::math::students_t(degrees_of_freedom), tail));
}

double student_p_value(double t, double degrees_of_freedom, Alternative alternative) {
  const boost::math::students_t student(degrees_of_freedom);
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

}  // namespace tcert
