#include "reports/hypothesis_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "analysis/study/verdict.hpp"
#include "reports/findings.hpp"
#include "reports/h1_intervals.hpp"
#include "reports/h1_within_table.hpp"
#include "reports/h3_chosen_table.hpp"
#include "reports/panel_rows.hpp"

namespace tcert {
namespace {

using study::H1Row;
using study::H1Score;

std::string words(study::Verdict verdict) { return std::string(study::to_string(verdict)); }

std::string score_words(const H1Score& score) { return in_words(score.value, score.interval); }

/// A score of H1, and the gain in it over a rival.
struct Comparison {
  const char* of;    ///< "success".
  const char* name;  ///< "AUC".
  const H1Score& (*score)(const H1Row&);
  const H1Score& (*gain)(const H1Row&);
  bool timed;
  bool within;
};

constexpr std::array<Comparison, 4> kComparisons{{
    {"success",
     "AUC",
     [](const H1Row& row) -> const H1Score& { return row.auc; },
     [](const H1Row& row) -> const H1Score& { return row.auc_gain; },
     false,
     false},
    {"success",
     "AUC",
     [](const H1Row& row) -> const H1Score& { return row.within.auc; },
     [](const H1Row& row) -> const H1Score& { return row.within.auc_gain; },
     false,
     true},
    {"time",
     "C",
     [](const H1Row& row) -> const H1Score& { return row.c; },
     [](const H1Row& row) -> const H1Score& { return row.c_gain; },
     true,
     false},
    {"time",
     "C",
     [](const H1Row& row) -> const H1Score& { return row.within.c; },
     [](const H1Row& row) -> const H1Score& { return row.within.c_gain; },
     true,
     true},
}};

std::string h1_evidence(const study::H1Panel& panel,
                        const Comparison& comparison,
                        const study::H1Verdict& found) {
  if (found.gain == nullptr) {
    const auto error = std::ranges::find(
        panel.conditions, statistics::ConditionSeverity::error, &statistics::Condition::severity);
    return error != panel.conditions.end() ? "No estimate: " + statistics::to_string(*error) + "."
                                           : "There is no gain to read.";
  }
  const H1Row& tested = panel.rows.front();
  const bool below = found.verdict == study::Verdict::contradicted;
  std::string between;
  if (comparison.within) {
    between = fmt::format(" The groups add {} to it.",
                          score_words(comparison.timed ? found.rival->within.c_gain_between
                                                       : found.rival->within.auc_gain_between));
  }
  return fmt::format("{} of {} {} in {} trials; the gain that {} is {}, over {}.{}",
                     comparison.name,
                     tested.name,
                     score_words(comparison.score(tested)),
                     panel.complete,
                     below ? "lies below 0" : "reaches lowest",
                     score_words(*found.gain),
                     found.rival->name,
                     between);
}

/// Without intervals there is one thing to say of a panel.
Finding withheld_finding(const study::H1Table& h1, const study::H1Panel& panel) {
  std::string evidence = "Intervals are withheld: " + panel.withheld + ".";
  for (const Comparison& comparison : kComparisons) {
    const study::H1Verdict found = study::h1_verdict(panel, comparison.gain);
    if (!comparison.within && found.gain != nullptr) {
      evidence += " " + h1_evidence(panel, comparison, found);
    }
  }
  return {fmt::format("H1, {} panel", panel_name(h1, panel)),
          words(study::Verdict::not_decided),
          evidence};
}

/// The panel that conclusions are drawn from first.
template <class Panel, class Kind>
std::vector<const Panel*> in_order(const std::vector<Panel>& panels, const Kind& kind_of) {
  std::vector<const Panel*> order;
  for (const bool landmark : {true, false}) {
    for (const Panel& panel : panels) {
      if ((kind_of(panel) == study::H1PanelKind::landmark) == landmark) {
        order.push_back(&panel);
      }
    }
  }
  return order;
}

/// The pair that decides, or is farthest from doing so.
std::string h2_evidence(const char* name,
                        const study::H2Panel& panel,
                        const study::H2Equality& equality) {
  const statistics::EquivalencePair* const pair = study::deciding_pair(panel, equality);
  if (pair == nullptr) {
    return "There are no two groups with intervals to compare.";
  }
  const auto& names = equality.groups.names;
  return fmt::format(
      "{} of {} less that of {}: {}, the pair farthest from equal; the margin of "
      "equivalence is {}, {} would have been enough.",
      name,
      names[pair->first],
      names[pair->second],
      in_words(pair->difference, pair->interval),
      significant(equality.tests.options.margin, 3),
      fixed(pair->smallest_margin, 3));
}

/// A law at its chosen beta, all lightings together.
Finding h3_finding(const study::H3Table& h3, const study::H3Chosen& one) {
  const study::H3Group& all = h3.groups.front();
  std::string evidence = fmt::format("Gain in rate of advance {} m/min beyond {}",
                                     in_words(one.gain.value, one.gain.interval, 2),
                                     in_words(all.ungated.value, {}, 2));
  if (one.recovered.value) {
    evidence +=
        fmt::format(", {} of the gap", in_words(one.recovered.value, one.recovered.interval, 2));
  }
  evidence += fmt::format("; {} of {} successes lost", one.lost, all.successes);
  if (one.lost_upper) {
    evidence += fmt::format(
        ", {} % of {} trials (bounds {} and {} %)",
        fixed(100.0 * static_cast<double>(one.lost) / static_cast<double>(one.trials), 1),
        one.trials,
        fixed(100.0 * *one.lost_lower, 1),
        fixed(100.0 * *one.lost_upper, 1));
  }
  if (!all.gap.interval || all.gap.interval->low <= 0.0) {
    evidence += ". A lead that could be won back is not shown";
  }
  if (!all.withheld.empty()) {
    evidence += ". Intervals are withheld: " + all.withheld;
  }
  return {fmt::format("H3, {} at beta {} 1/m", one.law, h3_betas(one)),
          words(study::h3_verdict(one, h3.options.loss_margin)),
          evidence + "."};
}

/// What holds of all laws and lightings at one time.
Finding h3_family_finding(const study::H3Table& h3) {
  std::string evidence;
  bool any_in_all = false;
  for (const study::H3Chosen& law : h3.chosen) {
    if (law.lighting != h3.groups.front().lighting) {
      continue;
    }
    std::string holding;
    std::size_t lightings = 0;
    std::size_t held = 0;
    for (const study::H3Chosen& one : h3.chosen) {
      if (one.law == law.law && one.lighting != law.lighting) {
        ++lightings;
        if (one.holds.value_or(false)) {
          ++held;
          holding += fmt::format(
              "{}{} (p {})", holding.empty() ? "" : ", ", one.lighting, significant(*one.holm, 2));
        }
      }
    }
    any_in_all = any_in_all || (lightings > 0 && held == lightings);
    evidence += fmt::format("{}of {} in {}",
                            evidence.empty() ? "A gain without too great a loss is shown " : "; ",
                            law.law,
                            holding.empty() ? "no lighting" : holding);
  }
  return {"H3, all laws and lightings at once",
          words(any_in_all ? study::Verdict::supported : study::Verdict::not_decided),
          evidence + "."};
}

}  // namespace

Table h1_findings(const study::H1Table& h1) {
  std::vector<Finding> findings;
  bool has_landmark = false;
  for (const study::H1Panel* const one :
       in_order(h1.panels, [](const study::H1Panel& panel) { return panel.kind; })) {
    const study::H1Panel& panel = *one;
    has_landmark = has_landmark || panel.kind == study::H1PanelKind::landmark;
    if (!panel.withheld.empty()) {
      findings.push_back(withheld_finding(h1, panel));
      continue;
    }
    const std::string columns = h1_within_columns(panel);
    for (const Comparison& comparison : kComparisons) {
      if ((comparison.within && columns.empty()) || (comparison.timed && !panel.has_time)) {
        continue;
      }
      const study::H1Verdict found = study::h1_verdict(panel, comparison.gain);
      findings.push_back({fmt::format("H1, {}{}, {} panel",
                                      comparison.of,
                                      comparison.within ? " within " + columns : "",
                                      panel_name(h1, panel)),
                          words(found.verdict),
                          h1_evidence(panel, comparison, found)});
    }
  }
  return findings_table(
      findings,
      {"Rule of H1: supported if the interval (" + h1_interval_text(h1.options) +
       ") of the gain over every single rival lies above 0, contradicted if that over one of them "
       "lies below 0, else not decided." +
       (has_landmark ? " Conclusions are drawn from the landmark panel: in the other one the early "
                       "window may contain the outcome."
                     : "")});
}

Table h2_findings(const study::H2Table& h2) {
  std::vector<Finding> findings;
  for (const study::H2Panel* const one :
       in_order(h2.panels, [](const study::H2Panel& panel) { return panel.trials.kind; })) {
    const study::H2Panel& panel = *one;
    const auto add = [&](const char* name, const std::optional<study::H2Equality>& equality) {
      const std::string about = fmt::format("H2, {}, {} panel", name, panel_name(h2, panel));
      if (equality) {
        findings.push_back({about,
                            words(study::h2_verdict(panel, *equality)),
                            h2_evidence(name, panel, *equality)});
      } else {
        findings.push_back(
            {about,
             words(study::Verdict::not_decided),
             fmt::format("Some group has no variance of its {}; the conditions say why.", name)});
      }
    };
    add("AUC", panel.auc);
    if (panel.trials.has_time) {
      add("C", panel.c);
    }
  }
  return findings_table(
      findings,
      {"Rule of H2: supported if the 90 % interval of every pair's difference lies within the "
       "margin (two one-sided tests at 5 %), contradicted if that of one pair lies outside of it, "
       "else not decided."});
}

Table h3_findings(const study::H3Table& h3) {
  std::vector<Finding> findings;
  if (!h3.groups.empty()) {
    for (const study::H3Chosen& one : h3.chosen) {
      if (one.lighting == h3.groups.front().lighting) {
        findings.push_back(h3_finding(h3, one));
      }
    }
    if (h3.groups.size() > 1) {
      findings.push_back(h3_family_finding(h3));
    }
  }
  const std::string level = significant(100.0 * h3.options.level, 3) + " %";
  return findings_table(
      findings,
      {"Rule of H3: supported if the " + level +
       " interval of the gain lies above 0 and the one-sided bound of the loss is below " +
       significant(100.0 * h3.options.loss_margin, 3) +
       " % of the trials, contradicted if the interval lies below 0 or the loss is above that "
       "margin with the same confidence, else not decided. Each law has one beta, chosen " +
       std::string(h3.options.beta.per_m ? "beforehand" : "on other days than it is judged on") +
       ". At once: p of the lack of a gain or of too great a loss, the larger of both, by Holm "
       "over "
       "all laws and lightings; supported if a law holds in every lighting."});
}

}  // namespace tcert
