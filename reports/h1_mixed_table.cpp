#include "reports/fit/cells.hpp"
#include "reports/h1_notes.hpp"
#include "reports/h1_table.hpp"
#include "reports/panel_rows.hpp"

namespace tcert {

Table h1_mixed_table(const study::H1Table& h1) {
  using Model = study::H1MixedModel;
  const std::string level = significant(100.0 * h1.options.level, kShownDigits) + " %";
  const auto model = ColumnsOf<Model>()
                         .estimate("or_per_sd", "OR per SD [" + level + "]", &Model::per_sd)
                         .estimate("or_per_cm", "OR per cm [" + level + "]", &Model::per_cm)
                         .p("p", "p", &Model::p_value)
                         .p("lr_p", "p of adding", &Model::lr_p_value)
                         .fixed("sd_cluster", "SD of clusters", &Model::sd_cluster)
                         .fixed("icc", "ICC", &Model::icc)
                         .fixed("r2_marginal", "R2 marginal", &Model::r2_marginal)
                         .fixed("r2_conditional", "R2 conditional", &Model::r2_conditional)
                         .fixed("loglik", "log-likelihood", &Model::log_likelihood);
  Table table = panel_columns<study::H1Row>()
                    .text("predictor", "predictor", &study::H1Row::name)
                    .part(model, [](auto& row) { return &row->mixed; })
                    .table("h1_mixed",
                           "H1, success by a logistic mixed model: " + h1_subject(h1),
                           rows_of(h1, &study::H1Panel::rows));
  table.n = static_cast<std::int64_t>(h1.trials);
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
