#include "reports/fit/coefficient_words.hpp"

#include <string>

#include "reports/columns_of.hpp"

namespace tcert {

std::string_view reason_without_estimate(statistics::CoefficientKind kind) {
  switch (kind) {
    case statistics::CoefficientKind::finite:
      return "";
    case statistics::CoefficientKind::not_estimable:
      return "not estimable";
    case statistics::CoefficientKind::plus_infinity:
      return "+infinity";
    case statistics::CoefficientKind::minus_infinity:
      return "-infinity";
    case statistics::CoefficientKind::diverging:
      return "diverging";
    case statistics::CoefficientKind::ran_away:
      return "near-separation";
    case statistics::CoefficientKind::unknown:
      return "unknown";
  }
  return "";
}

Table drop_table(const std::vector<statistics::DroppedTerm>& dropped,
                 std::string_view deviance_heading) {
  using Term = statistics::DroppedTerm;
  return ColumnsOf<Term>()
      .text("term", "term", &Term::term)
      .integer("df", "df", &Term::df)
      .number("deviance", std::string(deviance_heading), &Term::deviance)
      .number("AIC", "AIC without", &Term::aic)
      .number("statistic", "chi-squared", &Term::chi_squared)
      .p("p.value", "p", &Term::p_value)
      .table("drop1", "Likelihood-ratio test of each term", dropped);
}

}  // namespace tcert
