#include <string>

#include "reports/h1_table.hpp"
#include "reports/panel_rows.hpp"

namespace tcert {
namespace {

std::string outcome(bool success) { return success ? "success" : "failure"; }

}  // namespace

Table issuance_table(const study::H1Table& h1) {
  using Count = study::IssuedCount;
  Table table =
      ColumnsOf<Count>()
          .text("outcome", "outcome", [](auto& one) { return outcome(one.success); })
          .integer("issued", "issued", &Count::issued)
          .integer("trials", "trials", &Count::trials)
          .fixed("share", "share", [](auto& one) { return share(one.issued, one.trials); })
          .table("issued", "Certificates issued, by outcome", h1.issued);
  table.n = static_cast<std::int64_t>(h1.trials - h1.outcome_missing);
  return table;
}

Table tc_early_table(const study::H1Table& h1) {
  using Spread = study::TcDistribution;
  Table table =
      panel_columns<Spread>()
          .text("outcome", "outcome", [](auto& row) { return outcome(row->success); })
          .integer("trials", "trials", &Spread::trials)
          .fixed("p10_m", "p10", "m", 3, &Spread::p10)
          .fixed("p50_m", "p50", "m", 3, &Spread::p50)
          .fixed("p90_m", "p90", "m", 3, &Spread::p90)
          .fixed("missing_share",
                 "share NA",
                 [](auto& row) { return share(row->missing, row->trials); })
          .fixed("negative_share",
                 "share below 0",
                 [](auto& row) { return share(row->negative, row->trials - row->missing); })
          .table("tc_early",
                 "Spread of the early certificate margin, by outcome",
                 rows_of(h1, &study::H1Panel::distribution));
  table.n = static_cast<std::int64_t>(h1.trials - h1.outcome_missing);
  table.footnotes = {"share below 0: of the trials in which TC_early is known."};
  return table;
}

}  // namespace tcert
