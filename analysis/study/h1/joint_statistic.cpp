#include "analysis/study/h1/joint_statistic.hpp"

#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/concordance/concordance_statistic.hpp>
#include <statistics/resampling/jackknife.hpp>
#include <statistics/roc/auc_statistic.hpp>
#include <vector>

#include "analysis/study/h1/model_left_out.hpp"
#include "analysis/study/h1/within_strata.hpp"

namespace tcert::study {
namespace {

std::vector<statistics::Predictor> predictors_of(const H1Data& data) {
  std::vector<statistics::Predictor> predictors;
  for (std::size_t k = 0; k < data.predictors.size(); ++k) {
    predictors.push_back(data.timed(k));
  }
  return predictors;
}

/// AUCs, or Cs, of the models.
statistics::Statistic of_models(const H1Data& data, const H1Models& models, bool timed) {
  const auto value = timed ? &H1Model::c : &H1Model::auc;
  statistics::Statistic statistic;
  statistic.rows = data.rows();
  statistic.values = models.models.size();
  statistic.make_kernel = [&models, value]() -> statistics::StatisticKernel {
    return [&models, value](std::span<const std::uint32_t> multiplicity, std::span<double> values) {
      for (std::size_t k = 0; k < models.models.size(); ++k) {
        values[k] = (models.models[k].*value)(multiplicity);
      }
    };
  };
  statistic.leave_one_out = [refits = statistic, &data, &models, timed](
                                const statistics::ResamplingPlan& plan,
                                std::span<std::vector<double>> out) {
    if (plan.units() <= statistics::kMostJackknifeClusters) {
      statistics::leave_one_out(refits, plan, out);
      return;
    }
    for (std::size_t k = 0; k < models.models.size(); ++k) {
      const H1Model& model = models.models[k];
      out[k] =
          (timed ? cox_left_out(data, model, plan) : logistic_left_out(data, model, plan)).score;
    }
  };
  return statistic;
}

}  // namespace

statistics::Statistic joint_statistic(const H1Data& data,
                                      const H1Layout& layout,
                                      const H1Models& models) {
  std::vector<statistics::Statistic> parts;
  const std::vector<statistics::Score> scores = data.scores();
  parts.push_back(statistics::auc_statistic(scores, data.success));
  if (layout.models > 0) {
    parts.push_back(of_models(data, models, false));
  }
  if (layout.has_time) {
    parts.push_back(statistics::concordance_statistic(*data.censored, predictors_of(data)));
    if (layout.models > 0) {
      parts.push_back(of_models(data, models, true));
    }
  }
  if (layout.has_strata) {
    parts.push_back(within_statistic(data));
  }
  return statistics::joined(std::move(parts));
}

}  // namespace tcert::study
