#include "analysis/study/trials/study_tables.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace tcert::study {
namespace {

constexpr std::array<std::string_view, 9> kPaperOrder = {
    "CB-V", "M1", "M2", "M3", "TD*Lite", "TVFH", "Dark", "Indoor", "Outdoor"};

/// The names at the front of kPaperOrder; lightings follow.
constexpr std::size_t kPaperAlgorithms = 6;

struct PublishedSpeed {
  std::string_view name;
  double speed_mps = 0.0;
};

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

/// Adds the trials of one group to another.
void add_group(const StudyGroup& part, StudyGroup& whole) {
  whole.trials += part.trials;
  whole.known += part.known;
  whole.successes += part.successes;
  whole.speed_cmd_mps.add(part.speed_cmd_mps);
  whole.loop_latency_ms.add(part.loop_latency_ms);
}

bool before(const std::string& a, const std::string& b) noexcept {
  const std::size_t rank_a = rank_of(a);
  const std::size_t rank_b = rank_of(b);
  return rank_a != rank_b ? rank_a < rank_b : a < b;
}

}  // namespace

TrialRecord summarise(const StudiedTrial& trial) {
  std::optional<SoughtWitness> sought;
  if (trial.proof) {
    sought = SoughtWitness{trial.proof->certificate_m()};
    if (trial.proof->edges) {
      sought->has_edges = true;
      sought->edges = trial.series.edges.size();
      sought->edges_proven = trial.proof->edges->proven();
    }
  }
  Tally speed_cmd_mps(trial.speed_cmd_mps);
  Tally loop_latency_ms(trial.loop_latency_ms);
  return {{*trial.row, trial.features, trial.not_issued, sought},
          speed_cmd_mps.median(),
          loop_latency_ms.median(),
          std::move(speed_cmd_mps),
          std::move(loop_latency_ms)};
}

bool StudyRecord::PaperOrder::operator()(const Key& a, const Key& b) const noexcept {
  return a.first != b.first ? before(a.first, b.first) : before(a.second, b.second);
}

void StudyRecord::add(TrialRecord&& trial) {
  const TrialRow& row = trial.row.trial;
  StudyGroup& cell = cells_[{row.algorithm, row.lighting}];
  cell.algorithm = row.algorithm;
  cell.lighting = row.lighting;
  ++cell.trials;
  cell.known += row.success.has_value() ? 1 : 0;
  cell.successes += row.success.value_or(false) ? 1 : 0;
  cell.speed_cmd_mps.add(trial.speed_cmd_mps);
  cell.loop_latency_ms.add(trial.loop_latency_ms);
  rows_.push_back(std::move(trial.row));
}

std::vector<StudyGroup> StudyRecord::by_cell() const {
  std::vector<StudyGroup> groups;
  for (const auto& [key, cell] : cells_) {
    groups.push_back(cell);
  }
  return groups;
}

StudyGroup StudyRecord::all() const {
  StudyGroup all;
  for (const auto& [key, cell] : cells_) {
    add_group(cell, all);
  }
  return all;
}

bool StudyRecord::is_of_paper() const {
  return !cells_.empty() && std::all_of(cells_.begin(), cells_.end(), [](const auto& cell) {
    return is_paper_algorithm(cell.second.algorithm);
  });
}

std::vector<StudyGroup> StudyRecord::by_algorithm() const { return merged(true); }
std::vector<StudyGroup> StudyRecord::by_lighting() const { return merged(false); }

std::vector<StudyGroup> StudyRecord::merged(bool by_algorithm) const {
  Groups merged;
  for (const auto& [key, cell] : cells_) {
    const Key wider = by_algorithm ? Key{cell.algorithm, ""} : Key{"", cell.lighting};
    StudyGroup& group = merged[wider];
    group.algorithm = wider.first;
    group.lighting = wider.second;
    add_group(cell, group);
  }
  std::vector<StudyGroup> groups;
  for (auto& [key, group] : merged) {
    groups.push_back(std::move(group));
  }
  return groups;
}

bool is_paper_algorithm(std::string_view name) noexcept { return rank_of(name) < kPaperAlgorithms; }

std::optional<double> published_speed_mps(std::string_view name) noexcept {
  const auto* const found = std::find_if(
      kPublishedSpeeds.begin(), kPublishedSpeeds.end(), [&](const PublishedSpeed& one) {
        return one.name == name;
      });
  return found == kPublishedSpeeds.end() ? std::nullopt : std::optional(found->speed_mps);
}

}  // namespace tcert::study
