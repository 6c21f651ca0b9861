#include <algorithm>
#include <statistics/cox/cox.hpp>
#include <statistics/model/factor_levels.hpp>
#include <stdexcept>
#include <utility>

namespace tcert::statistics {

CoxData cox_data(const ModelFrame& frame) { return cox_data(ModelFrame(frame)); }

CoxData cox_data(ModelFrame&& frame) {
  auto* const outcome = std::get_if<SurvivalOutcome>(&frame.outcome);
  if (outcome == nullptr) {
    throw std::invalid_argument("Cox model: the response must be Surv(), not " + frame.response);
  }
  CoxData data;
  data.outcome = std::move(*outcome);
  data.design = std::move(frame.design);
  data.terms = std::move(frame.terms);
  data.offset = std::move(frame.offset);
  data.weights = std::move(frame.weights);
  data.strata = std::move(frame.strata);
  data.cluster = std::move(frame.cluster);

  Eigen::Index kept = 0;
  for (std::size_t j = 0; j < frame.columns.size(); ++j) {
    // Any baseline hazard absorbs a constant.
    if (frame.term_of[j] != 0) {
      const auto column = static_cast<Eigen::Index>(j);
      if (kept != column) {
        data.design.col(kept) = data.design.col(column);
      }
      ++kept;
      data.columns.push_back(std::move(frame.columns[j]));
      data.term_of.push_back(frame.term_of[j] - 1);
    }
  }
  data.design.conservativeResize(Eigen::NoChange, kept);
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
