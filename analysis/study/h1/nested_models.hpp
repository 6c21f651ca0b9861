#pragma once
/// \file
/// Does the predictor under test add to its rivals? By whole clusters, for success and for time.

#include <optional>
#include <span>

#include "analysis/study/h1/model_scores.hpp"
#include "analysis/study/h1/panel_data.hpp"

namespace tcert::study {

/// Wald's test of one coefficient by Student's t with G - 1 degrees of freedom, G clusters; its
/// variance is the jackknife of whole clusters, (G - 1) / G sum_g (b_(-g) - b)^2, known as CV3
/// (Bell & McCaffrey 2002; MacKinnon, Nielsen & Webb 2023, J. Econometrics 232:272). The sandwich
/// rejects too often where clusters are few and predictors alike within them; the likelihood ratio
/// takes trials as independent. `without_cluster` holds a b_(-g) for each cluster, NaN where it has
/// no estimate: then there is no test. Empty also if the jackknife has no spread.
[[nodiscard]] std::optional<double> cluster_jackknife_p(double estimate,
                                                        std::span<const double> without_cluster);

/// Fills `auc_p`, `c_p` (cluster_jackknife_p of the predictor added, in the logistic and in the Cox
/// model) and `auc_lr_p`, `c_lr_p` of the row `added`. A row whose model has no finite fit has none
/// of them. O(clusters) fits.
void add_nested_tests(const H1Data& data, const H1Models& models, H1Panel& panel);

}  // namespace tcert::study
