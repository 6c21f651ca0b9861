#include "reports/certify_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <statistics/basics/quantile.hpp>
#include <string>
#include <string_view>
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
    issued += row.features.issued.value_or(false) ? 1 : 0;
    unconnected += row.features.certificate_m ? 0 : 1;
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

Finding trial_finding(const FeatureRow& row) {
  const study::Features& found = row.features;
  std::string evidence;
  if (!found.certificate_m) {
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
  std::vector<Finding> findings;
  if (rows.size() <= kFew) {
    for (const FeatureRow& row : rows) {
      findings.push_back(trial_finding(row));
    }
    return findings_table(findings);
  }
  std::array<OutcomeGroup, 3> groups{{{"success", "successes", true},
                                      {"failure", "failures", false},
                                      {"trial without outcome", "trials without outcome", {}}}};
  for (const FeatureRow& row : rows) {
    std::ranges::find(groups, row.trial.success, &OutcomeGroup::success)->add(row);
  }
  return findings_table({issued_finding(groups), early_finding(groups)});
}

}  // namespace tcert
