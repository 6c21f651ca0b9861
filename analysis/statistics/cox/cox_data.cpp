#include <algorithm>
#include <statistics/cox/cox.hpp>
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

}  // namespace tcert::statistics
