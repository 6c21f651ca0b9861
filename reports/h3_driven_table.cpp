#include "reports/h3_driven_table.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "analysis/study/driven/arm.hpp"
#include "analysis/study/replay/replay_record.hpp"
#include "analysis/study/verdict.hpp"
#include "reports/columns_of.hpp"
#include "reports/findings.hpp"
#include "reports/h1_intervals.hpp"
#include "reports/hypothesis_conditions.hpp"

namespace tcert {
namespace {

using study::ArmComparison;
using study::ArmTotals;
using study::H3Case;
using study::PairedArms;

/// An arm, with the replay of the base at its law and beta; null if there is none.
struct DrivenRow : RowOf<ArmComparison> {
  const H3Case* replay = nullptr;
};

/// The law that an arm of the base is gated by, if its name states the beta.
std::optional<SpeedLaw> law_of(const std::string& arm_name, const std::string& base) {
  if (!arm_name.starts_with(base + "+")) {
    return std::nullopt;
  }
  SpeedLaw other;
  other.beta_per_m *= 2.0;
  try {
    const study::Arm arm = study::parse_arm(arm_name, {});
    const bool is_stated =
        arm.law && study::parse_arm(arm_name, other).law->beta_per_m == arm.law->beta_per_m;
    return is_stated ? arm.law : std::nullopt;
  } catch (const std::invalid_argument&) {
    return std::nullopt;  // an arm that was named elsewhere
  }
}

bool is_gated(const std::string& arm_name, const std::string& base) {
  return arm_name.starts_with(base + "+") && arm_name != base + "+A1";
}

const H3Case* replay_of(const std::string& arm_name,
                        const std::string& base,
                        const study::H3Table& replays) {
  const std::optional<SpeedLaw> law = law_of(arm_name, base);
  if (!law || replays.groups.empty()) {
    return nullptr;
  }
  for (const H3Case& one : replays.groups.front().cases) {
    if (one.law == study::to_string(law->kind) && one.beta_per_m == law->beta_per_m) {
      return &one;
    }
  }
  return nullptr;
}

std::vector<DrivenRow> rows_of(const PairedArms& driven, const study::H3Table& replays) {
  std::vector<DrivenRow> rows;
  for (const ArmComparison& arm : driven.arms) {
    rows.push_back({{arm}, replay_of(arm.arm, driven.options.base, replays)});
  }
  return rows;
}

Table success_table(const PairedArms& driven, const std::vector<DrivenRow>& rows) {
  const std::string& base = driven.options.base;
  const auto replay_columns =
      ColumnsOf<H3Case>()
          .integer("replay_lost", "replay lost", &H3Case::lost)
          .estimate("replay_gain_m_per_min", "replay gain", "m/min", 2, &H3Case::gain);
  const auto columns =
      ColumnsOf<DrivenRow>()
          .text("arm", "arm", [](auto& r) { return r.of.arm; })
          .integer("pairs", "pairs", [](auto& r) { return static_cast<std::int64_t>(r.of.pairs); })
          .integer("base_successes",
                   base + " arrives",
                   [](auto& r) { return static_cast<std::int64_t>(r.of.base.successes); })
          .integer("successes",
                   "arrives",
                   [](auto& r) { return static_cast<std::int64_t>(r.of.own.successes); })
          .answer()
          .integer("lost", "lost", [](auto& r) { return static_cast<std::int64_t>(r.of.lost); })
          .answer()
          .integer("won", "won", [](auto& r) { return static_cast<std::int64_t>(r.of.won); })
          .answer()
          .estimate("difference",
                    "difference",
                    "",
                    3,
                    [](auto& r) { return Estimated(r.of.difference, r.of.difference_interval); })
          .fixed("loss_upper", "loss at most", &ArmComparison::loss_upper)
          .yes_or_no("non_inferior", "non-inferior", &ArmComparison::non_inferior)
          .p("mcnemar_p", "McNemar p", &ArmComparison::mcnemar_p)
          .integer("pairs_needed",
                   "pairs needed",
                   [](auto& r) -> std::optional<std::int64_t> {
                     return r.of.pairs_needed
                                ? std::optional(static_cast<std::int64_t>(*r.of.pairs_needed))
                                : std::nullopt;
                   })
          .estimate("gain_m_per_min", "gain", "m/min", 2, &ArmComparison::gain)
          .answer()
          .estimate("gap_recovered", "share of gap", "", 2, &ArmComparison::recovered)
          .part(replay_columns, [](auto& r) { return r.replay; });
  Table table = columns.table("h3_driven", "H3 in closed loop, against '" + base + "'", rows);
  const study::PairedOptions& o = driven.options;
  table.footnotes = {
      "Lost: worlds in which '" + base +
          "' arrives and the arm does not; won: the other way "
          "round. What is lost here a replay cannot see: failures that speed causes.",
      fmt::format(
          "Difference: successes of the arm less those of '{}', interval by days (t). Loss at "
          "most: one-sided {:g} % bound, of days or exact, whichever is larger; non-inferior if it "
          "is below {:g}. McNemar: exact, "
          "pairs as independent. Pairs needed: for {:g} % power, if no more is lost than won and "
          "as many "
          "pairs differ as here; NA if none does.",
          base,
          100.0 * o.level,
          o.loss_margin,
          100.0 * o.power),
      fmt::format("Gain: total metres over total minutes of the worlds in which both arrive, less "
                  "those of '{}' there; days resampled ({} resamples, seed {}). Gap: the same of "
                  "'{}'.",
                  base,
                  o.replicates,
                  o.seed,
                  o.lead),
      "Replay: what re-timing the logs of '" + base +
          "' at the same law says, where the arm's name states its beta."};
  if (driven.unknown > 0) {
    table.footnotes.push_back(std::to_string(driven.unknown) +
                              " trials without an outcome are left out.");
  }
  return table;
}

Table event_table(const std::vector<DrivenRow>& rows, const PairedArms& driven) {
  struct EventRow {
    std::string arm;
    const ArmTotals* totals;
    std::size_t trials;
  };
  std::vector<EventRow> events{{driven.options.base, &driven.base, driven.base_trials}};
  for (const DrivenRow& row : rows) {
    events.push_back({row.of.arm, &row.of.own, row.of.pairs});
  }
  const auto count = [](auto member) {
    return [member](const EventRow& row) { return static_cast<std::int64_t>(row.totals->*member); };
  };
  ColumnsOf<EventRow> columns;
  columns.text("arm", "arm", &EventRow::arm)
      .integer("trials", "trials", [](auto& r) { return static_cast<std::int64_t>(r.trials); })
      .integer("successes", "goal", count(&ArmTotals::successes))
      .integer("collisions", "collision", count(&ArmTotals::collisions))
      .integer("wedged", "wedged", count(&ArmTotals::wedged))
      .integer("timeouts", "timeout", count(&ArmTotals::timeouts))
      .fixed("peak_force_n", "peak force", "N", 1, [](auto& r) { return r.totals->peak_force_n; })
      .fixed("time_above_force_s",
             "time above force",
             "s",
             2,
             [](auto& r) { return r.totals->time_above_s; })
      .fixed("stalls", "stalls", "", 2, [](auto& r) { return r.totals->stalls; });
  Table table = columns.table("h3_events", "How trials end, and what the walls feel", events);
  table.footnotes = {
      "Peak force: median over trials. Time above the watched force, and stalls: means "
      "over trials."};
  return table;
}

study::Verdict verdict_of(const ArmComparison& arm, double margin) {
  const auto& gain = arm.gain.interval;
  if (gain && arm.loss_upper && gain->low > 0.0 && *arm.loss_upper < margin) {
    return study::Verdict::supported;
  }
  const bool loses = arm.loss_lower && *arm.loss_lower >= margin;
  return (gain && gain->high < 0.0) || loses ? study::Verdict::contradicted
                                             : study::Verdict::not_decided;
}

Table driven_findings(const PairedArms& driven, const std::vector<DrivenRow>& rows) {
  std::vector<Finding> findings;
  for (const DrivenRow& row : rows) {
    const ArmComparison& arm = row.of;
    std::string evidence = fmt::format(
        "{} of {} arrive, {} of '{}'; lost {}, won {}, difference {}. Gain {} m/min beyond {}",
        arm.own.successes,
        arm.pairs,
        arm.base.successes,
        driven.options.base,
        arm.lost,
        arm.won,
        in_words(arm.difference, arm.difference_interval),
        in_words(arm.gain.value, arm.gain.interval, 2),
        in_words(arm.base_rate.value, {}, 2));
    if (row.replay != nullptr) {
      evidence += fmt::format("; the replay says {} lost, gain {}",
                              row.replay->lost,
                              in_words(row.replay->gain.value, {}, 2));
    }
    findings.push_back(
        {"H3 in closed loop, " + arm.arm,
         is_gated(arm.arm, driven.options.base)
             ? std::string(study::to_string(verdict_of(arm, driven.options.loss_margin)))
             : "",
         evidence + "."});
  }
  return findings_table(
      findings,
      {fmt::format(
          "Rule of H3 in closed loop: supported if the interval of the gain lies above 0 and "
          "the one-sided bound of the loss is below {:g} % of the worlds, contradicted if "
          "the interval lies below 0 or the loss is above that margin with the same "
          "confidence, else not decided.",
          100.0 * driven.options.loss_margin)});
}

}  // namespace

FitReport h3_driven_report(const PairedArms& driven, const study::H3Table& replays) {
  const std::vector<DrivenRow> rows = rows_of(driven, replays);
  FitReport report;
  report.model = "h3_driven";
  Record summary("summary", "Options");
  summary.text("base", "base", driven.options.base)
      .text("lead", "lead", driven.options.lead)
      .text("pair", "pair", driven.options.pair)
      .number("level", "level", driven.options.level)
      .number("loss_margin", "loss margin", driven.options.loss_margin)
      .integer("replicates", "replicates", driven.options.replicates)
      .integer("seed", "seed", driven.options.seed);
  report.summary = std::move(summary).table();
  report.tables = {success_table(driven, rows), event_table(rows, driven)};
  report.conditions = driven.conditions;
  report.findings = driven_findings(driven, rows);
  return report;
}

}  // namespace tcert
