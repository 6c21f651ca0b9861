#include <algorithm>
#include <statistics/cox/cox.hpp>
#include <statistics/model/factor_levels.hpp>
#include <stdexcept>

namespace tcert::statistics {

CoxData cox_data(const ModelFrame& frame) {
  const auto* const outcome = std::get_if<SurvivalOutcome>(&frame.outcome);
  if (outcome == nullptr) {
    throw std::invalid_argument("Cox model: the response must be Surv(), not " + frame.response);
  }
  CoxData data;
  data.outcome = *outcome;
  data.terms = frame.terms;
  data.offset = frame.offset;
  data.weights = frame.weights;
  data.strata = frame.strata;
  data.cluster = frame.cluster;

  std::vector<Eigen::Index> kept;
  for (std::size_t j = 0; j < frame.columns.size(); ++j) {
    // Any baseline hazard absorbs a constant.
    if (frame.term_of[j] != 0) {
      kept.push_back(static_cast<Eigen::Index>(j));
      data.columns.push_back(frame.columns[j]);
      data.term_of.push_back(frame.term_of[j] - 1);
    }
  }
  data.design = frame.design(Eigen::all, kept);
  return data;
}

CoxData on_rows(const CoxData& data, const std::vector<std::size_t>& rows) {
  const std::vector<Eigen::Index> indices(rows.begin(), rows.end());
  CoxData chosen;
  chosen.columns = data.columns;
  chosen.terms = data.terms;
  chosen.term_of = data.term_of;
  chosen.outcome = on_rows(data.outcome, rows);
  chosen.design = data.design(indices, Eigen::all);
  if (data.offset) {
    chosen.offset = (*data.offset)(indices);
  }
  if (data.weights) {
    chosen.weights = (*data.weights)(indices);
  }
  if (data.strata) {
    chosen.strata = on_rows(*data.strata, rows);
  }
  if (data.cluster) {
    chosen.cluster = on_rows(*data.cluster, rows);
  }
  return chosen;
}

}  // namespace tcert::statistics
