#pragma once
/// \file
/// A formula evaluated on a table: outcome, design matrix, strata, clusters, on complete rows.
/// Checked against R's `model.frame` and `model.matrix` with treatment contrasts.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <statistics/basics/condition.hpp>
#include <statistics/model/formula.hpp>
#include <statistics/model/variable.hpp>
#include <statistics/survival/survival_outcome.hpp>
#include <string>
#include <table/data_table.hpp>
#include <table/factor.hpp>
#include <utility>
#include <variant>
#include <vector>

namespace tcert::statistics {

enum class RightSide {
  design,  ///< Columns of a linear predictor.
  groups,  ///< Groups to compare: the cross of all terms.
};

struct FrameOptions {
  References reference;
  std::string weights;  ///< Column of case weights; empty for none.
  std::string cluster;  ///< Column of the cluster, instead of cluster() in the formula.
  std::string strata;   ///< Column of the strata, beside strata() in the formula.
  RightSide right_side = RightSide::design;
  bool allow_infinite = false;  ///< Of predictors, where only ranks count.
  bool round_times = true;      ///< Times that differ by rounding are one (`round_times`).
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

/// Effects that vary at random between the levels of a factor; a row's are its row of `design`.
struct RandomEffects {
  std::string group;                 ///< "day", "lighting:day".
  table::Factor levels;              ///< Of the group, those that occur.
  Eigen::MatrixXd design;            ///< rows x columns.
  std::vector<std::string> columns;  ///< "(Intercept)", "x1".
};

struct ModelFrame {
  std::string formula;
  std::string response;  ///< As R prints it: "Surv(time, status == 2)".
  std::variant<NumberOutcome, CountOutcome, SurvivalOutcome> outcome;
  std::vector<std::string> outcome_levels;  ///< Of a text outcome: what is 0, then what is 1;
                                            ///< several words with commas between.

  Eigen::MatrixXd design;            ///< rows x columns; the intercept first if there is one.
  std::vector<std::string> columns;  ///< R's names: "(Intercept)", "lightingdim", "x1:lightingdim".
  std::vector<std::size_t> term_of;  ///< Per column: index into `terms` + 1; 0 is the intercept.
  std::vector<std::string> terms;    ///< "x1", "lighting", "x1:lighting".
  std::optional<table::Factor> groups;  ///< For RightSide::groups: "sex=1, ph.ecog=0"; or "all".

  std::optional<Eigen::VectorXd> offset;
  std::optional<Eigen::VectorXd> weights;
  std::optional<table::Factor> strata;  ///< Levels "bright" of one text, else "sex=1, arm=A".
  std::optional<table::Factor> cluster;
  std::vector<RandomEffects> random_effects;  ///< One a random term of the formula.

  std::vector<std::size_t> rows;   ///< Of the table, 0-based, those that are complete.
  std::vector<std::size_t> lines;  ///< Of the file, one of each row; empty if it is not known.
  std::size_t dropped = 0;         ///< Rows left out.
  std::vector<std::pair<std::string, std::size_t>> missing;  ///< Per variable: rows without it.
  Conditions conditions;  ///< Of the rows: missing, infinite, times, weights. An error leaves the
                          ///< frame without meaning.

  [[nodiscard]] std::size_t size() const noexcept { return rows.size(); }
};

/// Evaluates `formula` on `table`. The kind of outcome follows the response: Surv() -> survival
/// with rounded times, cbind() -> counts, anything else -> numbers. A text column whose levels are
/// words of outcome_of_cell() is 0 and 1 by these, any other of two levels, and factor(), in the
/// order of all its levels; so is a status; times and counts are numbers. Where infinities are
/// allowed, a row in which a product of a term is infinity times 0 is missing. \throws FormulaError
/// if a column is not in the table (with the nearest name), a variable cannot be evaluated (log of
/// a text column), an outcome of text has not two levels, a predictor without factor() is a column
/// of numbers spoiled by texts (MixedCells::is_spoiled()), or another column by words for missing
/// cells.
[[nodiscard]] ModelFrame model_frame(const Formula& formula,
                                     const table::DataTable& table,
                                     const FrameOptions& options = {});

/// Columns of the data that a model with these options uses: what is to be read.
[[nodiscard]] std::vector<std::string> columns_of(const Formula& formula,
                                                  const FrameOptions& options);

/// Makes a 0/1 number outcome one of counts; any other value is an error condition that names the
/// response. A count outcome stays. \throws FormulaError for a survival outcome.
void require_binary(ModelFrame& frame);

}  // namespace tcert::statistics
