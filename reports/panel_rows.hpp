#pragma once
/// \file
/// The rows of the tables of H1 and H2: what each panel has, with the panel.

#include <string>
#include <vector>

#include "analysis/study/h2/hypothesis_h2.hpp"
#include "reports/columns_of.hpp"

namespace tcert {

/// "paper" or "landmark"; "table" if there is one panel only, for which the features are as they
/// are.
[[nodiscard]] std::string panel_name(const study::H1Table& h1, const study::H1Panel& panel);
[[nodiscard]] std::string panel_name(const study::H2Table& h2, const study::H2Panel& panel);

template <class Part, class Panel = study::H1Panel>
struct InPanel {
  std::string name;  ///< Of the panel.
  const Panel* panel = nullptr;
  const Part* part = nullptr;

  const Part& operator*() const noexcept { return *part; }
  const Part* operator->() const noexcept { return part; }
};

template <class Hypothesis, class Part, class Panel>
[[nodiscard]] std::vector<InPanel<Part, Panel>> rows_of(const Hypothesis& hypothesis,
                                                        std::vector<Part> Panel::*parts) {
  std::vector<InPanel<Part, Panel>> rows;
  for (const Panel& panel : hypothesis.panels) {
    for (const Part& part : panel.*parts) {
      rows.push_back({panel_name(hypothesis, panel), &panel, &part});
    }
  }
  return rows;
}

/// The first column of each of these tables.
template <class Part, class Panel = study::H1Panel>
[[nodiscard]] ColumnsOf<InPanel<Part, Panel>> panel_columns() {
  ColumnsOf<InPanel<Part, Panel>> columns;
  columns.text("panel", "panel", &InPanel<Part, Panel>::name);
  return columns;
}

/// Panel and predictor of a row of H1.
[[nodiscard]] ColumnsOf<InPanel<study::H1Row>> predictor_columns();

/// Of a score: NAME_std_error, NAME_low, NAME_high in closed form.
[[nodiscard]] ColumnsOf<study::H1Score> closed_form_columns(const std::string& name,
                                                            const std::string& heading);

}  // namespace tcert
