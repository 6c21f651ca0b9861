#include "analysis/study_tables.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "analysis/quantile.hpp"

namespace tcert {
namespace {

constexpr std::array<std::string_view, 9> kPaperOrder = {
    "CB-V", "M1", "M2", "M3", "TD*Lite", "TVFH", "Dark", "Indoor", "Outdoor"};

// Section 4.1; "0.17-0.18" and "0.13-0.14" by their middles.
constexpr std::array kPublishedSpeeds = {PublishedSpeed{"CB-V", 0.19},
                                         PublishedSpeed{"TD*Lite", 0.18},
                                         PublishedSpeed{"M1", 0.175},
                                         PublishedSpeed{"TVFH", 0.17},
                                         PublishedSpeed{"M3", 0.135},
                                         PublishedSpeed{"M2", 0.12},
                                         PublishedSpeed{"Indoor", 0.175},
                                         PublishedSpeed{"Outdoor", 0.148},
                                         PublishedSpeed{"Dark", 0.136}};

std::size_t rank_of(std::string_view name) noexcept {
  return static_cast<std::size_t>(std::find(kPaperOrder.begin(), kPaperOrder.end(), name) -
                                  kPaperOrder.begin());
}

using Key = std::pair<std::string, std::string>;  // algorithm, lighting

struct KeyOrder {
  bool operator()(const Key& a, const Key& b) const noexcept {
    return a.first != b.first ? paper_order(a.first, b.first) : paper_order(a.second, b.second);
  }
};

std::optional<double> known_median(std::span<const double> sample) {
  std::vector<double> known;
  std::copy_if(sample.begin(), sample.end(), std::back_inserter(known), [](double v) {
    return !std::isnan(v);
  });
  return median(known);
}

Key key_of(const TrialRow& row, MedianGroup group) {
  switch (group) {
    case MedianGroup::algorithm:
      return {row.algorithm, ""};
    case MedianGroup::lighting:
      return {"", row.lighting};
    case MedianGroup::cell:
      break;
  }
  return {row.algorithm, row.lighting};
}

}  // namespace

TrialSummary summarise(const StudiedTrial& trial) {
  return {{*trial.row, trial.features},
          known_median(trial.speed_cmd_mps),
          known_median(trial.loop_latency_ms)};
}

std::vector<CellCount> count_successes(std::span<const TrialSummary> trials) {
  std::map<Key, CellCount, KeyOrder> cells;
  for (const TrialSummary& trial : trials) {
    const TrialRow& row = trial.row.trial;
    CellCount& cell = cells[key_of(row, MedianGroup::cell)];
    cell.trials += row.success.has_value() ? 1 : 0;
    cell.successes += row.success.value_or(false) ? 1 : 0;
  }
  std::vector<CellCount> result;
  for (auto& [key, cell] : cells) {
    cell.algorithm = key.first;
    cell.lighting = key.second;
    result.push_back(std::move(cell));
  }
  return result;
}

std::vector<GroupMedian> group_medians(std::span<const TrialSummary> trials, MedianGroup group) {
  struct Samples {
    std::size_t trials = 0;
    std::vector<double> speeds;
    std::vector<double> latencies;
  };
  std::map<Key, Samples, KeyOrder> groups;
  for (const TrialSummary& trial : trials) {
    Samples& samples = groups[key_of(trial.row.trial, group)];
    ++samples.trials;
    if (trial.median_speed_cmd_mps) {
      samples.speeds.push_back(*trial.median_speed_cmd_mps);
    }
    if (trial.median_loop_latency_ms) {
      samples.latencies.push_back(*trial.median_loop_latency_ms);
    }
  }
  std::vector<GroupMedian> result;
  for (const auto& [key, samples] : groups) {
    result.push_back(
        {key.first, key.second, samples.trials, median(samples.speeds), median(samples.latencies)});
  }
  return result;
}

std::span<const PublishedSpeed> published_speeds() noexcept { return kPublishedSpeeds; }

bool paper_order(std::string_view a, std::string_view b) noexcept {
  return std::make_pair(rank_of(a), a) < std::make_pair(rank_of(b), b);
}

}  // namespace tcert
