#include <cstdint>
#include <string>

#include "reports/fit/cells.hpp"
#include "reports/h1_table.hpp"

namespace tcert {
namespace {

std::string outcome(bool success) { return success ? "success" : "failure"; }

TableCell share(std::size_t part, std::size_t whole) {
  return whole == 0 ? TableCell{} : Number{static_cast<double>(part) / static_cast<double>(whole)};
}

}  // namespace

Table issuance_table(const study::H1Table& h1) {
  Table table;
  table.name = "issued";
  table.title = "Certificates issued, by outcome";
  table.n = static_cast<std::int64_t>(h1.trials - h1.outcome_missing);
  table.columns = {{"outcome", "outcome", "", ColumnKind::text},
                   {"issued", "issued", "", ColumnKind::integer},
                   {"trials", "trials", "", ColumnKind::integer},
                   {"share", "share", "", ColumnKind::number, 3}};
  for (const study::IssuedCount& count : h1.issued) {
    table.add_row({outcome(count.success),
                   integer_cell(count.issued),
                   integer_cell(count.trials),
                   share(count.issued, count.trials)});
  }
  return table;
}

Table tc_early_table(const study::H1Table& h1) {
  Table table;
  table.name = "tc_early";
  table.title = "Spread of the early certificate margin, by outcome";
  table.n = static_cast<std::int64_t>(h1.trials - h1.outcome_missing);
  table.columns = {{"panel", "panel", "", ColumnKind::text},
                   {"outcome", "outcome", "", ColumnKind::text},
                   {"trials", "trials", "", ColumnKind::integer},
                   {"p10_m", "p10", "m", ColumnKind::number, 3},
                   {"p50_m", "p50", "m", ColumnKind::number, 3},
                   {"p90_m", "p90", "m", ColumnKind::number, 3},
                   {"missing_share", "share NA", "", ColumnKind::number, 3},
                   {"negative_share", "share below 0", "", ColumnKind::number, 3}};
  for (const study::H1Panel& panel : h1.panels) {
    for (const study::TcDistribution& one : panel.distribution) {
      table.add_row({panel_name(h1, panel),
                     outcome(one.success),
                     integer_cell(one.trials),
                     number_cell(one.p10),
                     number_cell(one.p50),
                     number_cell(one.p90),
                     share(one.missing, one.trials),
                     share(one.negative, one.trials - one.missing)});
    }
  }
  table.footnotes = {"share below 0: of the trials in which TC_early is known."};
  return table;
}

}  // namespace tcert
