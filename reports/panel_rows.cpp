#include "reports/panel_rows.hpp"

namespace tcert {
namespace {

std::string name_of(study::H1PanelKind kind, std::size_t panels) {
  const bool alone = panels == 1 && kind == study::H1PanelKind::paper;
  return alone ? "table" : std::string(study::to_string(kind));
}

}  // namespace

std::string panel_name(const study::H1Table& h1, const study::H1Panel& panel) {
  return name_of(panel.kind, h1.panels.size());
}

std::string panel_name(const study::H2Table& h2, const study::H2Panel& panel) {
  return name_of(panel.trials.kind, h2.panels.size());
}

ColumnsOf<InPanel<study::H1Row>> predictor_columns() {
  return panel_columns<study::H1Row>().text("predictor", "predictor", &study::H1Row::name);
}

ColumnsOf<study::H1Score> closed_form_columns(const std::string& name, const std::string& heading) {
  return ColumnsOf<study::H1Score>()
      .number(name + "_std_error", heading, &study::H1Score::std_error)
      .ends({name + "_low", "low"}, {name + "_high", "high"}, &study::H1Score::closed_form);
}

}  // namespace tcert
