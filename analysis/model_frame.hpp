#pragma once
/// \file
/// A formula evaluated on a table: outcome, design matrix, strata, clusters, on complete rows.
/// Checked against R's `model.frame` and `model.matrix` with treatment contrasts.

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/condition.hpp"
#include "analysis/formula.hpp"
#include "analysis/survival_outcome.hpp"
#include "datasets/data_table.hpp"
#include "datasets/factor.hpp"

namespace tcert {

struct FrameOptions {
  std::map<std::string, std::string> reference;  ///< Factor column -> its reference level.
  std::string weights;                           ///< Column of case weights; empty for none.
  std::string cluster;  ///< Column of the cluster, beside or instead of cluster() in the formula.
  std::string strata;   ///< The same for strata().
};

/// Successes out of trials, one row each; a 0/1 outcome has trials of 1.
struct CountOutcome {
  std::vector<double> successes;
  std::vector<double> trials;
};

/// A plain number as the outcome.
struct NumberOutcome {
  std::vector<double> values;
};

struct ModelFrame {
  std::string formula;
  std::string response;  ///< As R prints it: "Surv(time, status == 2)".
  std::variant<NumberOutcome, CountOutcome, SurvivalOutcome> outcome;

  Eigen::MatrixXd design;            ///< rows x columns; the intercept first if there is one.
  std::vector<std::string> columns;  ///< R's names: "(Intercept)", "lightingdim", "x1:lightingdim".
  std::vector<std::size_t> term_of;  ///< Per column: index into `terms` + 1; 0 is the intercept.
  std::vector<std::string> terms;    ///< "x1", "lighting", "x1:lighting".
  std::optional<Eigen::VectorXd> offset;
  std::optional<Eigen::VectorXd> weights;
  std::optional<Factor> strata;  ///< Levels as R's strata() names them: "lighting=dim".
  std::optional<Factor> cluster;
  std::vector<std::pair<std::string, Factor>> random_groups;

  std::vector<std::size_t> rows;  ///< Of the table, 0-based, those that are complete.
  std::size_t dropped = 0;        ///< Rows left out.
  std::vector<std::pair<std::string, std::size_t>> missing;  ///< Rows lost per column of the data.
  Conditions conditions;  ///< Of the rows: missing, infinite, not binary, times, weights, constant
                          ///< columns. Errors leave the frame without meaning.

  [[nodiscard]] std::size_t size() const noexcept { return rows.size(); }
};

/// Evaluates `formula` on `table`. The kind of outcome follows the response: Surv() -> survival
/// with snapped times, cbind() -> counts, anything else -> numbers (a text column or factor() with
/// two levels is 0 and 1 in level order). \throws FormulaError if a column is not in the table
/// (with the nearest name) or a variable cannot be evaluated (log of a text column).
[[nodiscard]] ModelFrame model_frame(const Formula& formula,
                                     const DataTable& table,
                                     const FrameOptions& options = {});

}  // namespace tcert
