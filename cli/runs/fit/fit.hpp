#pragma once
/// \file
/// `fit`: a model on any table.

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

/// By kind of fit, not by size.
struct FitRequest {  // NOLINT(clang-analyzer-optin.performance.Padding)
  std::string kind;
  std::string data;
  std::string formula;
  std::string cluster;
  std::string strata;
  std::string weights;
  std::vector<std::string> references;  ///< COLUMN=LEVEL.
  double level = 0.95;
  std::string table;
  bool no_time_rounding = false;
  // cox
  std::string ties = "efron";
  bool robust = false;
  std::string transform = "km";
  std::string residuals;
  std::string curves;
  // glm and cox
  std::string predict;
  std::string inference;  ///< Empty: by the number of clusters.
  bool left_out = false;
  std::string contrasts;
  // glm
  bool no_profile = false;
  bool firth = false;
  // calibration
  std::int64_t folds = 5;
  std::string predicted;
  // glmm
  std::optional<std::int64_t> quadrature;  ///< None: the model's own.
  bool profile = false;
  bool drop1 = false;
  // lmm
  bool ml = false;
  // km
  std::string interval = "log";
  std::string times;
  double rho = 0.0;
  std::string rmst;
  // km and finegray
  std::string cause;
  std::string event;
  // concordance
  std::string pair_weight = "n";
  bool reverse = false;
  // roc
  std::string partial;
  // roc and concordance
  std::int64_t replicates = 0;

  OutputOptions output;
  std::int64_t seed = 1;
  std::int64_t threads = 0;
  bool decimal_comma = false;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(FitRequest& request);

/// \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode fit(const FitRequest& request, Progress& progress);

}  // namespace tcert::cli
