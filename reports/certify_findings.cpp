#include "reports/certify_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <statistics/basics/quantile.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/findings.hpp"

namespace tcert {
namespace {

using study::FeatureRow;

/// So many trials are named one by one.
constexpr std::size_t kFew = 5;

/// Trials of one outcome.
struct OutcomeGroup {
  std::string_view one;
  std::string_view several;
  std::optional<bool> success;
  std::size_t trials = 0;
  std::size_t issued = 0;
  std::size_t unconnected = 0;
  std::vector<double> tc_early = {};

  void add(const FeatureRow& row) {
    ++trials;
    const bool is_issued = row.features.issued.value_or(false);
    issued += is_issued ? 1 : 0;
    unconnected += is_issued || row.features.certificate_m ? 0 : 1;
    if (row.features.tc_early) {
      tc_early.push_back(*row.features.tc_early);
    }
  }
};

/// "582 of 583 successes, 0 of 77 failures": `text_of` of every group that has trials.
template <class Text>
std::string listed(std::span<const OutcomeGroup> groups, const Text& text_of) {
  std::string text;
  for (const OutcomeGroup& group : groups) {
    if (group.trials > 0) {
      text += (text.empty() ? "" : ", ") + text_of(group);
    }
  }
  return text;
}

std::string_view name_of(const OutcomeGroup& group, std::size_t number) {
  return number == 1 ? group.one : group.several;
}

Finding issued_finding(std::span<const OutcomeGroup> groups) {
  std::string evidence =
      "T_t was above 0 in " + listed(groups, [](const OutcomeGroup& group) {
        return fmt::format("{} of {} {}", group.issued, group.trials, name_of(group, group.trials));
      });
  std::size_t unconnected = 0;
  std::size_t narrow = 0;
  for (const OutcomeGroup& group : groups) {
    unconnected += group.unconnected;
    narrow += group.trials - group.issued - group.unconnected;
  }
  if (unconnected > 0) {
    evidence += fmt::format("; start (S) and goal (G) were never connected in {}", unconnected);
  }
  if (narrow > 0) {
    evidence += fmt::format("; the margin on the way was not above 0 in {}", narrow);
  }
  return {"Certificates issued", "", evidence + "."};
}

/// Why a certificate was not issued, to follow "no certificate: "; of the first trial of many, its
/// numbers.
std::string reason_text(const study::NotIssued& why) {
  using enum study::NotIssuedReason;
  switch (why.reason) {
    case no_goal:
      return "the course has no goal (G)";
    case no_evidence:
      return "no tick has both a pose and a reading";
    case start_outside:
      return fmt::format("the first tick with a pose and a reading lies {} m outside the start (S)",
                         fixed(why.distance_m, 2));
    case goal_missed:
      return fmt::format("the goal (G) was never entered, {} m off at the nearest",
                         fixed(why.distance_m, 2));
    case broken:
      return "start (S) and goal (G) were never connected, for the path is broken";
    case unconnected:
      return "start (S) and goal (G) were never connected";
    case no_witness:
      return "no path as wide as the body was found in what was felt";
    case narrow:
      return fmt::format("the margin is {} m at ({}, {}), which is not above 0{}",
                         fixed(why.margin_m, 3),
                         fixed(why.place.x_m, 2),
                         fixed(why.place.y_m, 2),
                         why.across_heading ? "; the robot moved across its heading there, where "
                                              "its sides count for less (across_heading)"
                                            : "");
  }
  return "";
}

/// The reason of most of the trials without a certificate, with the first of them that has it.
std::optional<Finding> most_frequent_reason(std::span<const FeatureRow> rows) {
  const auto is_success = [](const FeatureRow& row) { return row.trial.success.value_or(false); };
  const auto is_issued = [](const FeatureRow& row) { return !row.not_issued.has_value(); };
  const bool any_success = std::ranges::any_of(rows, is_success);
  std::map<study::NotIssuedReason, std::vector<const FeatureRow*>> by_reason;
  std::size_t trials = 0;
  for (const FeatureRow& row : rows) {
    if (any_success && !is_success(row)) {
      continue;
    }
    if (is_issued(row)) {
      return std::nullopt;
    }
    ++trials;
    by_reason[row.not_issued->reason].push_back(&row);
  }
  if (by_reason.empty()) {
    return std::nullopt;
  }
  const auto most = std::ranges::max_element(
      by_reason, {}, [](const auto& entry) { return entry.second.size(); });
  const FeatureRow& first = *most->second.front();
  return Finding{"Why none",
                 "",
                 fmt::format("in {} of {} {}: {} (in {}).",
                             most->second.size(),
                             trials,
                             any_success ? "successes" : "trials",
                             reason_text(*first.not_issued),
                             first.trial.trial_id)};
}

Finding early_finding(std::span<const OutcomeGroup> groups) {
  return {"Early certificate", "", "TC_early: " + listed(groups, [](const OutcomeGroup& group) {
                                     if (group.tc_early.empty()) {
                                       return fmt::format("NA in the {}", group.several);
                                     }
                                     const std::size_t missing =
                                         group.trials - group.tc_early.size();
                                     return fmt::format(
                                         "median {} m in the {}{}",
                                         fixed(*statistics::median(group.tc_early), 3),
                                         group.several,
                                         missing > 0 ? fmt::format(" (NA in {})", missing) : "");
                                   }) + "."};
}

/// What the search for witnesses found, if there was one.
std::optional<Finding> witness_finding(std::span<const FeatureRow> rows) {
  std::vector<double> margins;
  std::size_t sought = 0;
  std::size_t edges = 0;
  std::size_t edges_proven = 0;
  bool has_edges = false;
  for (const FeatureRow& row : rows) {
    sought += row.witness ? 1 : 0;
    if (row.witness && row.witness->has_edges) {
      has_edges = true;
      edges += row.witness->edges;
      edges_proven += row.witness->edges_proven;
    }
    if (row.witness && row.witness->margin_m.value_or(0.0) > 0.0) {
      margins.push_back(*row.witness->margin_m);
    }
  }
  if (sought == 0) {
    return std::nullopt;
  }
  std::string evidence = fmt::format(
      "{} of {} trials have a path that proves a margin above 0", margins.size(), sought);
  if (!margins.empty()) {
    evidence += fmt::format(", {} m in the median; each is in certificates.csv (witness_m)",
                            fixed(*statistics::median(margins), 3));
  }
  if (has_edges) {
    evidence += fmt::format("; so have {} of {} edges (proved_m)", edges_proven, edges);
  }
  return Finding{"Witnesses", "", evidence + "."};
}

Finding trial_finding(const FeatureRow& row) {
  const study::Features& found = row.features;
  std::string evidence;
  if (row.not_issued) {
    evidence = "no certificate: " + reason_text(*row.not_issued) + ".";
  } else if (!found.certificate_m) {
    evidence = "no certificate: start (S) and goal (G) were never connected.";
  } else if (found.issued.value_or(false) && found.issued_s) {
    evidence = fmt::format("T_t is {} m at the end; a certificate is issued from {} s on.",
                           fixed(*found.certificate_m, 3),
                           fixed(*found.issued_s, 1));
  } else {
    evidence = fmt::format("no certificate: T_t is {} m at the end, which is not above 0.",
                           fixed(*found.certificate_m, 3));
  }
  return {row.trial.trial_id, "", evidence};
}

}  // namespace

Table certify_findings(std::span<const FeatureRow> rows) {
  std::array<OutcomeGroup, 3> groups{{{"success", "successes", true},
                                      {"failure", "failures", false},
                                      {"trial without outcome", "trials without outcome", {}}}};
  for (const FeatureRow& row : rows) {
    std::ranges::find(groups, row.trial.success, &OutcomeGroup::success)->add(row);
  }
  std::vector<Finding> findings;
  if (rows.size() <= kFew) {
    for (const FeatureRow& row : rows) {
      findings.push_back(trial_finding(row));
    }
  }
  if (rows.size() > 1) {
    findings.push_back(issued_finding(groups));
  }
  if (rows.size() > kFew) {
    findings.push_back(early_finding(groups));
  }
  if (auto found = witness_finding(rows)) {
    findings.push_back(std::move(*found));
  }
  if (auto reason = rows.size() > 1 ? most_frequent_reason(rows) : std::nullopt) {
    findings.push_back(std::move(*reason));
  }
  return findings_table(findings);
}

}  // namespace tcert
