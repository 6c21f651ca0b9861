#include "analysis/study/h1/curves.hpp"

#include <statistics/calibration/out_of_fold.hpp>
#include <statistics/resampling/cross_validation.hpp>
#include <utility>

namespace tcert::study {
namespace {

void add_roc(const H1Data& data,
             const H1Models& models,
             const std::vector<double>& success,
             H1Panel& panel) {
  for (std::size_t k = 0; k < data.predictors.size(); ++k) {
    panel.roc.push_back(
        {panel.rows[k].name, statistics::roc_curve(data.predictors[k], success, data.higher[k])});
  }
  const std::vector<std::uint8_t> all(data.rows(), 1);
  for (std::size_t m = 0; m < models.models.size(); ++m) {
    if (const auto scores = models.models[m].logistic_scores(all)) {
      panel.roc.push_back(
          {panel.rows[data.predictors.size() + m].name,
           statistics::roc_curve(*scores, success, statistics::HigherMeans::success)});
    }
  }
}

void add_calibration(const std::string& name,
                     const H1Model& model,
                     const statistics::Folds& folds,
                     const std::vector<double>& success,
                     const H1Data& data,
                     const H1Options& options,
                     H1Panel& panel) {
  const statistics::OutOfFold predicted =
      statistics::out_of_fold_probabilities(model.logistic(), folds);
  statistics::CalibrationOptions calibration_options;
  calibration_options.level = options.level;
  panel.calibration.push_back(
      {name,
       statistics::calibration(
           success, predicted.probability, &data.cluster, calibration_options)});
}

}  // namespace

void add_curves(const H1Data& data,
                const H1Models& models,
                const H1Options& options,
                H1Panel& panel) {
  const std::vector<double> success(data.success.begin(), data.success.end());
  add_roc(data, models, success, panel);
  statistics::FoldOptions fold_options;
  fold_options.folds = options.folds;
  fold_options.seed = options.seed;
  const statistics::Folds folds =
      statistics::assign_folds(data.success, data.cluster.codes, fold_options);
  if (folds.count < 2) {
    return;
  }
  const H1Model alone(data, {0});
  add_calibration(panel.rows.front().name, alone, folds, success, data, options, panel);
  for (std::size_t m = 0; m < models.models.size(); ++m) {
    add_calibration(panel.rows[data.predictors.size() + m].name,
                    models.models[m],
                    folds,
                    success,
                    data,
                    options,
                    panel);
  }
}

}  // namespace tcert::study
