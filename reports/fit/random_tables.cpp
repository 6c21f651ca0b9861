#include "reports/fit/random_tables.hpp"

#include "reports/columns_of.hpp"

namespace tcert {

std::vector<RandomParameter> random_parameters(const statistics::GlmmRandomTerm& term) {
  std::vector<RandomParameter> all;
  for (std::size_t a = 0; a < term.columns.size(); ++a) {
    all.push_back({"sd__" + term.columns[a], term.sd[a]});
  }
  for (std::size_t a = 1; a < term.columns.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      all.push_back({"cor__" + term.columns[b] + "." + term.columns[a],
                     term.correlation(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b))});
    }
  }
  return all;
}

Table boundary_table(const std::vector<statistics::GlmmRandomTerm>& random) {
  using Term = statistics::GlmmRandomTerm;
  using Test = statistics::BoundaryTest;
  const auto test = ColumnsOf<Test>()
                        .text("dropped", "without", &Test::column)
                        .number("statistic", "chi-squared", &Test::chi_squared)
                        .number("df", "df up to", &Test::df)
                        .p("p.value", "p", &Test::p_value);
  return ColumnsOf<Term>()
      .text("group", "group", &Term::group)
      .integer("levels", "levels", [](auto& term) { return term.levels.size(); })
      .yes_or_no("singular", "singular", &Term::singular)
      .part(test, &Term::test)
      .table(
          "random", "Random effects, each against the model without it (on the boundary)", random);
}

Table mode_table(const std::vector<statistics::GlmmRandomTerm>& random) {
  struct Mode {
    const statistics::GlmmRandomTerm& of;
    std::size_t level;
    std::size_t column;
  };
  const auto entry = [](const Eigen::MatrixXd& values, const Mode& r) {
    return values(static_cast<Eigen::Index>(r.level), static_cast<Eigen::Index>(r.column));
  };
  const auto columns =
      ColumnsOf<Mode>()
          .text("effect", "effect", [](auto&) { return "ran_vals"; })
          .text("group", "group", [](auto& r) { return r.of.group; })
          .text("level", "level", [](auto& r) { return r.of.levels[r.level]; })
          .text("term", "term", [](auto& r) { return r.of.columns[r.column]; })
          .number("estimate", "mode", [=](auto& r) { return entry(r.of.modes, r); })
          .number("std.error", "SD", [=](auto& r) { return entry(r.of.mode_sds, r); });
  Table table = columns.table("ran_vals", "Conditional modes of the random effects");
  for (const statistics::GlmmRandomTerm& term : random) {
    for (std::size_t level = 0; level < term.levels.size(); ++level) {
      for (std::size_t k = 0; k < term.columns.size(); ++k) {
        table.add_row(columns.row({term, level, k}));
      }
    }
  }
  return table;
}

}  // namespace tcert
