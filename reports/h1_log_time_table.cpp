#include <statistics/clusters/cluster_inference.hpp>

#include "reports/fit/cells.hpp"
#include "reports/h1_table.hpp"
#include "reports/panel_rows.hpp"

namespace tcert {

Table h1_log_time_table(const study::H1Table& h1) {
  using Model = study::H1LogTime;
  const std::string level = significant(100.0 * h1.options.level, kShownDigits) + " %";
  const auto model = ColumnsOf<Model>()
                         .fixed("r2_marginal", "R2 marginal", &Model::r2_marginal)
                         .estimate("r2_gain",
                                   "gain [" + level + "]",
                                   [](auto& r) { return Estimated(r.r2_gain, r.r2_gain_interval); })
                         .p("r2_gain_p", "p", &Model::r2_gain_p)
                         .fixed("r2_conditional", "R2 conditional", &Model::r2_conditional)
                         .estimate("time_ratio",
                                   "time per SD [" + level + "]",
                                   [](auto& r) { return Estimated(r.ratio, r.interval); })
                         .p("time_ratio_p", "p", &Model::p_value)
                         .fixed("sd_cluster", "SD of clusters", &Model::sd_cluster);
  Table table = panel_columns<study::H1Row>()
                    .text("predictor", "predictor", &study::H1Row::name)
                    .part(model, [](auto& row) { return &row->log_time; })
                    .table("h1_log_time",
                           "H1, R2 of log time: " + h1_subject(h1),
                           rows_of(h1, &study::H1Panel::rows));
  table.n = static_cast<std::int64_t>(h1.trials);
  table.footnotes = {
      "Linear mixed model of the logarithm of the time of trials that reach the goal, random "
      "intercept by '" +
          h1.options.cluster +
          "', REML. R2 is Nakagawa's; its gain is that of the marginal one, by the jackknife of "
          "whole clusters and t with clusters - 1 degrees of freedom, of up to " +
          std::to_string(statistics::kMostJackknifeClusters) +
          " clusters; where each trial is its own cluster there is no such model.",
      "Time per SD: what the time is multiplied by per standard deviation towards the better side, "
      "by t with Satterthwaite's degrees of freedom. Failures have no such time: those that "
      "arrive are a choice, which C and the hazard ratios do not make."};
  return table;
}

}  // namespace tcert
