#include "reports/fit/cells.hpp"
#include "reports/h1_notes.hpp"
#include "reports/h1_table.hpp"

namespace tcert {
namespace {

TableCell ratio(const study::H1OddsRatio& one) { return estimate_cell(one.ratio, one.interval); }

}  // namespace

Table h1_mixed_table(const study::H1Table& h1) {
  const std::string level = significant(100.0 * h1.options.level, kShownDigits) + " %";
  Table table;
  table.name = "h1_mixed";
  table.title = "H1, success by a logistic mixed model: " + h1_subject(h1);
  table.n = static_cast<std::int64_t>(h1.trials);
  table.columns = {text_column("panel", "panel"),
                   text_column("predictor", "predictor"),
                   estimate_column("or_per_sd", "OR per SD [" + level + "]"),
                   estimate_column("or_per_cm", "OR per cm [" + level + "]"),
                   p_column("p", "p"),
                   p_column("lr_p", "p of adding"),
                   fixed_column("sd_cluster", "SD of clusters"),
                   fixed_column("icc", "ICC"),
                   fixed_column("r2_marginal", "R2 marginal"),
                   fixed_column("r2_conditional", "R2 conditional"),
                   fixed_column("loglik", "log-likelihood")};
  for (const study::H1Panel& panel : h1.panels) {
    for (const study::H1Row& row : panel.rows) {
      table.add_row({panel_name(h1, panel),
                     row.name,
                     ratio(row.mixed.per_sd),
                     ratio(row.mixed.per_cm),
                     p_cell(row.mixed.p_value),
                     p_cell(row.mixed.lr_p_value),
                     number_cell(row.mixed.sd_cluster),
                     number_cell(row.mixed.icc),
                     number_cell(row.mixed.r2_marginal),
                     number_cell(row.mixed.r2_conditional),
                     number_cell(row.mixed.log_likelihood)});
    }
  }
  table.footnotes = {
      "Random intercept by '" + h1.options.cluster +
          "', adaptive quadrature; Wald intervals and tests. Odds ratios are within a cluster, per "
          "standard deviation towards the better side; of 'rivals + ...' the predictor's, rivals "
          "held fixed, and p of adding it is the likelihood ratio.",
      "SD of clusters in log odds; ICC and R2 on the latent scale (Nakagawa), residual pi^2/3. An "
      "SD of 0 is a singular fit. The model takes trials of a cluster as independent given its "
      "intercept."};
  return table;
}

}  // namespace tcert
