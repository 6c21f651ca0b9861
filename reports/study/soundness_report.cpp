#include "reports/study/soundness_report.hpp"

#include <fmt/format.h>

#include <utility>

#include "reports/columns_of.hpp"
#include "reports/findings.hpp"
#include "reports/study/study_summary.hpp"

namespace tcert {
namespace {

using study::SoundnessMethod;
using study::SoundnessSummary;
using study::Tightness;

struct RateRow {
  std::string worlds_of;
  const SoundnessMethod* method = nullptr;
  SoundnessSummary summary;
};

Table rate_table(const SoundnessRuns& runs) {
  std::vector<RateRow> rows;
  const auto add =
      [&](std::string worlds_of, const SoundnessMethod& method, const SoundnessSummary& summary) {
        if (summary.worlds > 0) {
          rows.push_back({std::move(worlds_of), &method, summary});
        }
      };
  for (const SoundnessWorlds& kind : runs.kinds) {
    for (std::size_t m = 0; m < kind.methods.size(); ++m) {
      add(kind.name, kind.methods[m], kind.tally.of_all(m));
    }
    for (const WorldFamily family : kind.families) {
      for (std::size_t m = 0; m < kind.methods.size(); ++m) {
        add(std::string(name_of(family)), kind.methods[m], kind.tally.of(family, m));
      }
    }
  }
  const auto count = [](auto member) {
    return [member](const RateRow& row) { return static_cast<std::int64_t>(row.summary.*member); };
  };
  ColumnsOf<RateRow> columns;
  columns.text("worlds_of", "worlds", &RateRow::worlds_of)
      .text("method", "method", [](const RateRow& row) { return row.method->name; })
      .yes_or_no("noise", "noise", [](const RateRow& row) { return row.method->noise; })
      .integer("worlds", "n", count(&SoundnessSummary::worlds))
      .integer("violating_worlds", "worlds violated", count(&SoundnessSummary::violations))
      .answer()
      .fixed("largest_excess_m",
             "largest excess",
             "m",
             4,
             [](const RateRow& row) { return row.summary.largest_excess_m; })
      .number("rate",
              "rate",
              [](const RateRow& row) {
                return static_cast<double>(row.summary.violations) /
                       static_cast<double>(row.summary.worlds);
              })
      .number("upper_95",
              "rate at most",
              [](const RateRow& row) { return row.summary.violation_bound(); })
      .answer()
      .integer("ticks", "ticks", count(&SoundnessSummary::ticks))
      .integer("issued", "issued", count(&SoundnessSummary::issued))
      .integer("untraversable", "T <= 0", count(&SoundnessSummary::untraversable))
      .integer("issued_untraversable", "issued, T <= 0", count(&SoundnessSummary::spurious))
      .integer("violating_ticks", "ticks violated", count(&SoundnessSummary::violating_ticks))
      .integer(
          "worst_world", "worst world", [](const RateRow& row) { return row.summary.worst_world; });
  Table table = columns.table("soundness", "Is the certificate at most the truth?", rows);
  table.footnotes = {
      "A violation is T_t > T at any tick, however small. The bound is on the rate of worlds: "
      "one-sided, 95 %, Clopper-Pearson. U-turns are held against their exact T, the others "
      "against that by clearance."};
  return table;
}

Table tightness_table(const SoundnessRuns& runs) {
  struct Row {
    const SoundnessMethod* method = nullptr;
    Tightness tightness;
  };
  std::vector<Row> rows;
  for (const SoundnessWorlds& kind : runs.kinds) {
    for (std::size_t m = 0; m < kind.methods.size(); ++m) {
      for (const Tightness& one : kind.tally.tightness(m)) {
        rows.push_back({&kind.methods[m], one});
      }
    }
  }
  ColumnsOf<Row> columns;
  columns
      .text("family",
            "worlds",
            [](const Row& row) { return std::string(name_of(row.tightness.family)); })
      .text("method", "method", [](const Row& row) { return row.method->name; })
      .yes_or_no("noise", "noise", [](const Row& row) { return row.method->noise; })
      .integer("lanes_explored",
               "lanes explored",
               [](const Row& row) { return std::int64_t{row.tightness.explored}; })
      .integer("lanes", "of", [](const Row& row) { return std::int64_t{row.tightness.lanes}; })
      .integer("worlds",
               "n",
               [](const Row& row) { return static_cast<std::int64_t>(row.tightness.worlds); })
      .fixed("median_gap_m",
             "median gap",
             "m",
             4,
             [](const Row& row) { return row.tightness.median_m; })
      .fixed("p90_gap_m", "90 % below", "m", 4, [](const Row& row) { return row.tightness.p90_m; });
  Table table = columns.table("tightness", "How far below the truth does it end?", rows);
  table.footnotes = {"T - T_t at the end of the runs that reached G."};
  return table;
}

/// "radial: 0; width: 2, by at most 0.0060 m", of the methods with or without noise.
std::string claimed_too_much(const SoundnessWorlds& kind, bool noise) {
  std::string text;
  for (std::size_t m = 0; m < kind.methods.size(); ++m) {
    if (kind.methods[m].noise != noise) {
      continue;
    }
    const SoundnessSummary& summary = kind.tally.of_all(m);
    text +=
        fmt::format("{}{}: {}", text.empty() ? "" : "; ", kind.methods[m].name, summary.violations);
    if (summary.violations > 0) {
      text += fmt::format(", by at most {:.4f} m", summary.largest_excess_m);
    }
  }
  return text;
}

Table soundness_findings(const SoundnessRuns& runs) {
  std::vector<Finding> findings;
  for (const SoundnessWorlds& kind : runs.kinds) {
    for (const bool noise : {false, true}) {
      if (const std::string counts = claimed_too_much(kind, noise);
          !counts.empty() && kind.tally.worlds() > 0) {
        findings.push_back({"T_t above the truth, " + kind.name + (noise ? ", noise" : ""),
                            "",
                            fmt::format("of {} worlds {}.", kind.tally.worlds(), counts)});
      }
    }
  }
  return findings_table(findings);
}

}  // namespace

FitReport soundness_report(const SoundnessRuns& runs) {
  FitReport report = study_report("soundness", runs.seed);
  std::vector<std::pair<std::string, std::uint64_t>> counts;
  for (const SoundnessWorlds& kind : runs.kinds) {
    counts.emplace_back(kind.name, kind.tally.worlds());
  }
  counts.emplace_back("seed", runs.seed);
  report.summary = study_summary(counts);
  report.findings = soundness_findings(runs);
  report.tables = {rate_table(runs), tightness_table(runs)};
  return report;
}

}  // namespace tcert
