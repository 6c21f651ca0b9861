#include <statistics/survival/fine_gray.hpp>

#include <algorithm>
#include <numeric>
#include <statistics/survival/censoring_curve.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tcert::statistics {
namespace {

void check(const CoxData& data, const CompetingOutcome& outcome, std::size_t cause) {
  if (outcome.stop.size() != data.rows() || outcome.cause.size() != data.rows()) {
    throw std::invalid_argument("Fine-Gray model: rows differ");
  }
  if (!outcome.start.empty() || data.weights) {
    throw std::invalid_argument("Fine-Gray model: rows that enter late, or with weights");
  }
  if (cause >= outcome.causes.size()) {
    throw std::invalid_argument("Fine-Gray model: no such cause");
  }
}

/// The rows of each stratum; one without strata.
std::vector<std::vector<std::size_t>> rows_of_strata(const CoxData& data) {
  std::vector<std::vector<std::size_t>> rows(data.strata ? data.strata->levels.size() : 1);
  for (std::size_t row = 0; row < data.rows(); ++row) {
    rows[data.strata ? data.strata->codes[row] : 0].push_back(row);
  }
  return rows;
}

/// Appends spans of risk of one row each.
class WeightedRows {
 public:
  void add(std::size_t row, double start, double stop, bool event, double weight) {
    if (rows.size() >= kMostFineGrayRows) {
      throw std::invalid_argument("Fine-Gray model: more than " +
                                  std::to_string(kMostFineGrayRows) + " weighted rows");
    }
    rows.push_back(row);
    outcome.start.push_back(start);
    outcome.stop.push_back(stop);
    outcome.event.push_back(event ? 1 : 0);
    weights.push_back(weight);
  }

  std::vector<std::size_t> rows;
  SurvivalOutcome outcome;
  std::vector<double> weights;
};

/// After another event at `time`: at risk at the later events of the cause, as heavy as G says.
void add_after_competing(std::size_t row,
                         double time,
                         const std::vector<double>& events,
                         const CensoringCurve& censoring,
                         WeightedRows& weighted) {
  const double whole = censoring.before(time);
  double start = time;
  for (auto event = std::upper_bound(events.begin(), events.end(), time); event != events.end();) {
    const double weight = censoring.before(*event) / whole;
    auto last = event;
    while (std::next(last) != events.end() &&
           censoring.before(*std::next(last)) / whole == weight) {
      ++last;
    }
    if (!(weight > 0.0)) {
      return;
    }
    weighted.add(row, start, *last, false, weight);
    start = *last;
    event = std::next(last);
  }
}

}  // namespace

CoxData fine_gray_data(const CoxData& data, const CompetingOutcome& outcome, std::size_t cause) {
  check(data, outcome, cause);
  const auto code = static_cast<std::uint32_t>(cause) + 1;
  const std::vector<double>& times = outcome.stop;
  std::vector<std::uint8_t> censored;
  for (const std::uint32_t end : outcome.cause) {
    censored.push_back(end == 0 ? 1 : 0);
  }
  WeightedRows weighted;
  for (const std::vector<std::size_t>& rows : rows_of_strata(data)) {
    const CensoringCurve censoring(times, censored, rows);
    std::vector<double> events;
    for (const std::size_t row : rows) {
      if (outcome.cause[row] == code) {
        events.push_back(outcome.stop[row]);
      }
    }
    std::sort(events.begin(), events.end());
    events.erase(std::unique(events.begin(), events.end()), events.end());
    for (const std::size_t row : rows) {
      const std::uint32_t end = outcome.cause[row];
      weighted.add(row, 0.0, outcome.stop[row], end == code, 1.0);
      if (end != 0 && end != code) {
        add_after_competing(row, outcome.stop[row], events, censoring, weighted);
      }
    }
  }
  CoxData clustered = data;
  clustered.outcome = {{}, outcome.stop, std::vector<std::uint8_t>(data.rows(), 0)};
  if (!clustered.cluster) {
    clustered.cluster.emplace();
    clustered.cluster->codes.resize(data.rows());
    std::iota(clustered.cluster->codes.begin(), clustered.cluster->codes.end(), 0U);
    clustered.cluster->levels.resize(data.rows());
  }
  CoxData result = on_rows(clustered, weighted.rows);
  result.outcome = std::move(weighted.outcome);
  result.weights = Eigen::Map<const Eigen::VectorXd>(
      weighted.weights.data(), static_cast<Eigen::Index>(weighted.weights.size()));
  return result;
}

CoxData cause_specific_data(const CoxData& data,
                            const CompetingOutcome& outcome,
                            std::size_t cause) {
  check(data, outcome, cause);
  CoxData result = data;
  result.outcome = {{}, outcome.stop, {}};
  for (const std::uint32_t end : outcome.cause) {
    result.outcome.event.push_back(end == cause + 1 ? 1 : 0);
  }
  return result;
}

}  // namespace tcert::statistics
