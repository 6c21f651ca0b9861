#pragma once
/// \file
/// `tcert fit`: its options and, for each kind of model, from a table to a report.

#include <cstdint>
#include <map>
#include <statistics/model/formula.hpp>
#include <statistics/model/model_frame.hpp>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "reports/fit/fit_report.hpp"

namespace tcert::cli {

struct FitOptions {
  std::string kind;
  std::string data;
  std::string formula;
  std::string cluster;
  std::string strata;
  std::string weights;
  std::vector<std::string> references;  ///< COLUMN=LEVEL.
  std::string table;
  double level = 0.95;

  bool no_time_rounding = false;

  // cox
  std::string ties = "efron";
  bool robust = false;
  std::string transform = "km";
  std::string residuals;
  std::string curves;
  // glm
  bool no_profile = false;
  bool firth = false;
  // calibration
  std::int64_t folds = 5;
  std::string predicted;
  // glmm
  int quadrature = 0;  ///< 0: the model's own.
  bool profile = false;
  bool drop1 = false;
  // km
  std::string interval = "log";
  std::vector<double> times;
  double rho = 0.0;
  std::string cause;
  // concordance
  std::string pair_weight = "n";
  bool reverse = false;
  // roc
  std::string partial;
  // bootstrap of roc and concordance
  std::int64_t replicates = 0;
  std::uint64_t seed = 1;
  bool quiet = false;
};

/// A fit's inputs: the frame is without an error.
struct FitRequest {
  const FitOptions& options;
  const statistics::Formula& formula;
  const table::DataTable& table;
  statistics::ModelFrame& frame;
};

[[nodiscard]] FitReport fit_glm(const FitRequest& request);
[[nodiscard]] FitReport fit_calibration(const FitRequest& request);
[[nodiscard]] FitReport fit_mixed_model(const FitRequest& request);
[[nodiscard]] FitReport fit_cox_model(const FitRequest& request);
[[nodiscard]] FitReport fit_km(const FitRequest& request);
[[nodiscard]] FitReport fit_roc(const FitRequest& request);
[[nodiscard]] FitReport fit_concordance(const FitRequest& request);

/// The word of an option among those allowed. \throws UsageError that names them.
[[nodiscard]] std::size_t choice(const std::string& option,
                                 const std::string& word,
                                 const std::vector<std::string>& words);

}  // namespace tcert::cli
