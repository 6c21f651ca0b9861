#include "analysis/study/h1/out_of_fold.hpp"

#include <limits>
#include <statistics/resampling/cross_validation.hpp>

namespace tcert::study {
namespace {

using FoldRows = std::span<const std::size_t>;

/// Scores of the held-out rows by a fit to the training rows; NaN if there is no estimate, which
/// leaves the fold out.
template <class Scores>
std::vector<double> scored(std::size_t rows,
                           FoldRows training,
                           FoldRows held_out,
                           const Scores& scores) {
  std::vector<std::uint8_t> train(rows, 0);
  for (const std::size_t row : training) {
    train[row] = 1;
  }
  const std::optional<std::vector<double>> all = scores(train);
  std::vector<double> chosen;
  chosen.reserve(held_out.size());
  for (const std::size_t row : held_out) {
    chosen.push_back(all ? (*all)[row] : std::numeric_limits<double>::quiet_NaN());
  }
  return chosen;
}

void note_folds(const statistics::Folds& folds, const H1Data& data, H1Panel& panel) {
  std::vector<std::size_t> fold_of(data.cluster.levels.size(), 0);
  for (std::size_t row = 0; row < data.rows(); ++row) {
    fold_of[data.cluster.codes[row]] = folds.of_row[row] + 1;
  }
  for (std::size_t level = 0; level < fold_of.size(); ++level) {
    panel.folds.emplace_back(data.cluster.levels[level], fold_of[level]);
  }
}

std::optional<double> value_of(const statistics::PooledScore& score,
                               const std::string& name,
                               H1Row& row) {
  for (statistics::Condition condition : score.conditions) {
    condition.column = row.name;
    condition.detail = name + (condition.detail.empty() ? "" : ": " + condition.detail);
    row.conditions.push_back(std::move(condition));
  }
  return score.value;
}

}  // namespace

void add_out_of_fold(const H1Data& data,
                     const H1Models& models,
                     const H1Options& options,
                     H1Panel& panel) {
  statistics::FoldOptions fold_options;
  fold_options.folds = options.folds;
  fold_options.seed = options.seed;
  const statistics::Folds folds =
      statistics::assign_folds(data.success, data.cluster.codes, fold_options);
  panel.conditions.insert(panel.conditions.end(), folds.conditions.begin(), folds.conditions.end());
  if (folds.count < 2) {
    return;
  }
  note_folds(folds, data, panel);
  const std::size_t predictors = data.predictors.size();
  for (std::size_t k = 0; k < predictors; ++k) {
    H1Row& row = panel.rows[k];
    row.auc_within_folds = value_of(
        statistics::out_of_fold_auc(folds, data.predictors[k], data.success, data.higher[k]),
        "out-of-fold AUC",
        row);
    if (data.censored) {
      row.c_within_folds =
          value_of(statistics::out_of_fold_c(
                       folds, data.predictors[k], *data.censored, data.timed(k).larger),
                   "out-of-fold C",
                   row);
    }
  }
  for (std::size_t m = 0; m < models.models.size(); ++m) {
    const H1Model& model = models.models[m];
    H1Row& row = panel.rows[predictors + m];
    const std::vector<double> logistic =
        statistics::out_of_fold_scores(folds, [&](FoldRows training, FoldRows held_out) {
          return scored(data.rows(), training, held_out, [&](const auto& train) {
            return model.logistic_scores(train);
          });
        });
    row.auc_within_folds = value_of(
        statistics::out_of_fold_auc(folds, logistic, data.success), "out-of-fold AUC", row);
    if (data.censored) {
      const std::vector<double> cox =
          statistics::out_of_fold_scores(folds, [&](FoldRows training, FoldRows held_out) {
            return scored(data.rows(), training, held_out, [&](const auto& train) {
              return model.cox_scores(train);
            });
          });
      row.c_within_folds =
          value_of(statistics::out_of_fold_c(folds, cox, *data.censored), "out-of-fold C", row);
    }
  }
}

}  // namespace tcert::study
