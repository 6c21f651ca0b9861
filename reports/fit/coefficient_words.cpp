#include "reports/fit/coefficient_words.hpp"

#include <string>

#include "reports/fit/cells.hpp"

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
  Table table;
  table.name = "drop1";
  table.title = "Likelihood-ratio test of each term";
  table.columns = {text_column("term", "term"),
                   integer_column("df", "df"),
                   number_column("deviance", std::string(deviance_heading)),
                   number_column("AIC", "AIC without"),
                   number_column("statistic", "chi-squared"),
                   p_column()};
  for (const statistics::DroppedTerm& one : dropped) {
    table.add_row({one.term,
                   integer_cell(one.df),
                   number_cell(one.deviance),
                   number_cell(one.aic),
                   number_cell(one.chi_squared),
                   p_cell(one.p_value)});
  }
  return table;
}

}  // namespace tcert
