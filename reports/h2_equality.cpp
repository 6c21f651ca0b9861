#include "reports/h2_equality.hpp"

#include "reports/fit/interval_columns.hpp"
#include "reports/h2_notes.hpp"
#include "reports/panel_rows.hpp"

namespace tcert {
namespace {

using study::H2Panel;

/// AUC or C of a panel.
struct Quantity {
  std::string panel_name;
  std::string name;
  const H2Panel& panel;
  const study::H2Equality& equality;
};

std::vector<Quantity> quantities_of(const study::H2Table& h2) {
  std::vector<Quantity> all;
  for (const H2Panel& panel : h2.panels) {
    if (panel.auc) {
      all.push_back({panel_name(h2, panel), "AUC", panel, *panel.auc});
    }
    if (panel.c) {
      all.push_back({panel_name(h2, panel), "C", panel, *panel.c});
    }
  }
  return all;
}

template <class Row>
ColumnsOf<Row> quantity_columns() {
  return ColumnsOf<Row>()
      .text("panel", "panel", [](const Quantity& r) { return r.panel_name; })
      .text("quantity", "of", [](const Quantity& r) { return r.name; });
}

/// Two groups of a quantity.
struct Groups : Quantity {
  std::size_t first = 0;
  std::size_t second = 0;

  [[nodiscard]] bool is_withheld() const {
    return !panel.levels[first].withheld.empty() || !panel.levels[second].withheld.empty();
  }
};

ColumnsOf<Groups> group_columns() {
  return quantity_columns<Groups>()
      .text("first", "first", [](auto& r) { return r.equality.groups.names[r.first]; })
      .text("second", "second", [](auto& r) { return r.equality.groups.names[r.second]; });
}

}  // namespace

Table h2_equality_table(const study::H2Table& h2) {
  using Tests = statistics::Equivalence;
  using Range = statistics::RangeUnderEquality;
  const auto tests = ColumnsOf<Tests>()
                         .fixed("margin", "margin", [](auto& one) { return one.options.margin; })
                         .yes_or_no("equivalent", "equivalent", &Tests::equivalent)
                         .p("p_tost", "p of equivalence", &Tests::p_value)
                         .fixed("smallest_margin", "smallest margin", &Tests::smallest_margin)
                         .fixed("margin_80", "margin with 80 % power", &Tests::margin_with_power)
                         .part(chi_square_columns("p", "p of a difference"), &Tests::heterogeneity)
                         .fixed("range", "max - min", &Tests::range);
  const auto range = ColumnsOf<Range>()
                         .fixed("range_expected", "expected if equal", &Range::expected)
                         .fixed("range_95", "95 % below", &Range::upper)
                         .p("range_p", "p by permutation", &Range::p_value);
  Table table = quantity_columns<Quantity>()
                    .part(tests, [](auto& r) { return &r.equality.tests; })
                    .part(range, [](auto& r) { return &r.equality.range; })
                    .table("h2_equality", "H2: equality of the groups", quantities_of(h2));
  table.footnotes = h2_equality_notes(h2);
  return table;
}

Table h2_pair_table(const study::H2Table& h2) {
  using Pair = statistics::EquivalencePair;
  struct Row : Groups {
    const Pair& pair;
  };
  const auto tests = ColumnsOf<Pair>()
                         .fixed("std_error", "SE", &Pair::standard_error)
                         .p("p_tost", "p of equivalence", &Pair::p_value)
                         .yes_or_no("equivalent", "equivalent", &Pair::equivalent)
                         .fixed("smallest_margin", "smallest margin", &Pair::smallest_margin);
  const auto columns =
      ColumnsOf<Row>()
          .part(group_columns(), [](auto& r) { return static_cast<const Groups*>(&r); })
          .estimate("difference",
                    "difference [90 %]",
                    [](auto& r) {
                      return Estimated(r.pair.difference, when(!r.is_withheld(), r.pair.interval));
                    })
          .part(tests, [](auto& r) { return r.is_withheld() ? nullptr : &r.pair; });
  Table table = columns.table("h2_pairs", "H2: differences of all pairs, with 90 % intervals");
  for (const Quantity& of : quantities_of(h2)) {
    for (const Pair& pair : of.equality.tests.pairs) {
      table.add_row(columns.row({{of, pair.first, pair.second}, pair}));
    }
  }
  return table;
}

Table h2_interaction_table(const study::H2Table& h2) {
  using study::H2Interaction;
  struct Row : RowOf<H2Interaction> {
    std::string panel;
    std::string test;
  };
  const auto columns = ColumnsOf<Row>()
                           .text("panel", "panel", &Row::panel)
                           .text("model", "model", &H2Interaction::model)
                           .text("test", "test", &Row::test)
                           .part(chi_square_columns("p"), &H2Interaction::test);
  Table table = columns.table("h2_interaction",
                              "H2: does the effect of the predictor differ between groups?");
  for (const H2Panel& panel : h2.panels) {
    for (const H2Interaction& one : panel.interactions) {
      table.add_row(
          columns.row({{one}, panel_name(h2, panel), "jackknife of clusters, Hotelling"}));
    }
    if (const auto& one = panel.mixed_interaction) {
      table.add_row(columns.row({{*one}, panel_name(h2, panel), "likelihood ratio"}));
    }
  }
  table.footnotes = {
      "Group x predictor beside both by themselves. The likelihood ratio takes trials of a cluster "
      "as independent given its intercept."};
  return table;
}

Table h2_covariance_table(const study::H2Table& h2) {
  const auto columns = group_columns().number("covariance", "covariance", [](auto& r) {
    return r.is_withheld()
               ? std::nullopt
               : std::optional(r.equality.groups.covariance(static_cast<Eigen::Index>(r.first),
                                                            static_cast<Eigen::Index>(r.second)));
  });
  Table table = columns.table("h2_covariance", "Covariance of the groups' AUCs and Cs");
  for (const Quantity& of : quantities_of(h2)) {
    for (std::size_t i = 0; i < of.equality.groups.names.size(); ++i) {
      for (std::size_t j = i; j < of.equality.groups.names.size(); ++j) {
        table.add_row(columns.row({of, i, j}));
      }
    }
  }
  return table;
}

}  // namespace tcert
