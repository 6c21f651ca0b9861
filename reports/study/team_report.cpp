#include "reports/study/team_report.hpp"

#include <fmt/format.h>

#include <statistics/basics/quantile.hpp>

#include "analysis/study/soundness/soundness_tally.hpp"
#include "reports/columns_of.hpp"
#include "reports/findings.hpp"
#include "reports/study/study_summary.hpp"

namespace tcert {
namespace {

using study::FederationMethod;
using study::FederationOutcome;
using study::kFederationMethods;
using study::kTeams;
using study::TeamOutcome;

const TeamOutcome& team_of(const FederationOutcome& world, std::size_t team, std::size_t method) {
  return world.teams[team * kFederationMethods.size() + method];
}

struct Row {
  std::size_t robots = 0;
  FederationMethod method = FederationMethod::witness;
  study::SoundnessSummary summary;
  std::size_t beaten = 0;  ///< Worlds in which T_H is more than the best alone.
  std::size_t below = 0;   ///< Worlds in which it is less: never.
  std::vector<double> times_s;
  std::vector<double> time_ratios;  ///< Of worlds issued by one robot and by the team.
  std::vector<double> dwell_ratios;
  std::vector<double> dwells_s;
  std::vector<double> bytes;  ///< Of a submap.
};

Row row_of(const std::vector<FederationOutcome>& worlds, std::size_t team, std::size_t method) {
  Row row;
  row.robots = kTeams.at(team);
  row.method = kFederationMethods.at(method);
  for (std::size_t w = 0; w < worlds.size(); ++w) {
    const TeamOutcome& one = team_of(worlds[w], team, method);
    const TeamOutcome& alone = team_of(worlds[w], 0, method);
    study::WorldOutcome world;
    world.truth_m = worlds[w].truth_m;
    study::SoundnessOutcome outcome;
    outcome.certificate_m = one.certificate_m;
    outcome.excess_m = one.certificate_m - world.truth_m;
    outcome.violating_ticks = outcome.excess_m > 0.0 ? 1U : 0U;
    outcome.issued = one.certificate_m > 0.0;
    row.summary.add(world, outcome, w);
    row.beaten += one.certificate_m > one.best_alone_m ? 1U : 0U;
    row.below += one.certificate_m < one.best_alone_m ? 1U : 0U;
    row.bytes.push_back(static_cast<double>(one.bytes) / static_cast<double>(row.robots));
    if (one.time_s) {
      row.times_s.push_back(*one.time_s);
      row.dwells_s.push_back(one.dwell_s);
      if (alone.time_s && *alone.time_s > 0.0) {
        row.time_ratios.push_back(*one.time_s / *alone.time_s);
        row.dwell_ratios.push_back(one.dwell_s / alone.dwell_s);
      }
    }
  }
  return row;
}

Table teams_table(const std::vector<Row>& rows) {
  const auto count = [](auto member) {
    return [member](const Row& row) { return static_cast<std::int64_t>(row.summary.*member); };
  };
  const auto median = [](std::vector<double> Row::*values) {
    return [values](const Row& row) { return statistics::quantile(row.*values, 0.5); };
  };
  ColumnsOf<Row> columns;
  columns.integer("robots", "robots", [](const Row& row) { return row.robots; })
      .text("margins", "margins", [](const Row& row) { return std::string(name_of(row.method)); })
      .integer("worlds", "n", count(&study::SoundnessSummary::worlds))
      .integer("untraversable", "T <= 0", count(&study::SoundnessSummary::untraversable))
      .integer("issued", "issued", count(&study::SoundnessSummary::issued))
      .answer()
      .integer("violating_worlds", "T_H > T", count(&study::SoundnessSummary::violations))
      .answer()
      .number(
          "upper_95", "rate at most", [](const Row& row) { return row.summary.violation_bound(); })
      .fixed("largest_excess_m",
             "largest excess",
             "m",
             4,
             [](const Row& row) { return row.summary.largest_excess_m; })
      .integer("above_best_alone", "above best alone", [](const Row& row) { return row.beaten; })
      .integer("below_best_alone", "below it", [](const Row& row) { return row.below; })
      .fixed("time_s", "time to T_H", "s", 1, median(&Row::times_s))
      .fixed("time_ratio", "to that of one", "", 2, median(&Row::time_ratios))
      .fixed("dwell_s", "worst dwell", "s", 1, median(&Row::dwells_s))
      .fixed("dwell_ratio", "to that of one", "", 2, median(&Row::dwell_ratios))
      .fixed("bytes", "bytes a submap", "", 0, median(&Row::bytes))
      .fixed("bytes_p95", "95 % below", "", 0, [](const Row& row) {
        return statistics::quantile(row.bytes, 0.95);
      });
  Table table = columns.table("teams", "Several robots that share one way", rows);
  table.footnotes = {
      "Of n robots number k sets off at k/n of the way and drives two n-ths of it. T_H > T: in the "
      "end, however little; the bound is on the rate of worlds, one-sided, 95 %, Clopper-Pearson.",
      "Times, dwells and bytes are medians; of those to that of one robot over worlds in which "
      "both "
      "are issued. Worst dwell: longest time that a robot has spent by then where no other had "
      "told "
      "of.",
      fmt::format("Frames off: each robot's by up to {} m and {} rad, which the joins know.",
                  study::kFrameErrorM,
                  study::kFrameErrorRad)};
  return table;
}

}  // namespace

FitReport team_report(const std::vector<FederationOutcome>& worlds, std::uint64_t seed) {
  std::vector<Row> rows;
  for (std::size_t method = 0; method < kFederationMethods.size(); ++method) {
    for (std::size_t team = 0; team < kTeams.size(); ++team) {
      rows.push_back(row_of(worlds, team, method));
    }
  }
  FitReport report = study_report("federation", seed);
  report.summary = study_summary({{"worlds", worlds.size()}, {"seed", seed}});
  std::vector<Finding> findings;
  for (std::size_t method = 0; method < kFederationMethods.size(); ++method) {
    std::string counts;
    for (std::size_t team = 0; team < kTeams.size(); ++team) {
      const Row& row = rows[method * kTeams.size() + team];
      counts += fmt::format("{}{} of {} worlds with {}",
                            team == 0 ? "" : ", ",
                            row.summary.violations,
                            row.summary.worlds,
                            row.robots);
    }
    findings.push_back(
        {fmt::format("T_H above the truth, {}", name_of(kFederationMethods.at(method))),
         "",
         counts + " robots."});
  }
  report.findings = findings_table(findings);
  report.tables = {teams_table(rows)};
  return report;
}

}  // namespace tcert
