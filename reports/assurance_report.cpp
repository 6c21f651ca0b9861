#include "reports/assurance_report.hpp"

#include <fmt/format.h>

#include <utility>

#include "reports/columns_of.hpp"
#include "reports/findings.hpp"

namespace tcert {
namespace {

using study::AssuredTrial;
using study::FaultScore;
using study::MonitorScore;

Estimated estimated(const study::ShareEstimate& share) { return {share.value, share.interval}; }

Table monitors_table(const study::Assurance& assurance) {
  Table table =
      ColumnsOf<MonitorScore>()
          .text("monitor", "rule", &MonitorScore::monitor)
          .integer("episodes", "unsafe episodes", [](auto& m) { return m.episodes.of; })
          .integer("detected", "detected", [](auto& m) { return m.episodes.found; })
          .estimate("share", "share", "", 3, [](auto& m) { return estimated(m.episodes); })
          .answer()
          .estimate(
              "ahead_share", "of a wall ahead", "", 3, [](auto& m) { return estimated(m.ahead); })
          .estimate("force_share", "of a force", "", 3, [](auto& m) { return estimated(m.force); })
          .integer("trials_unsafe", "trials with one", &MonitorScore::trials)
          .integer("trials_whole", "of them all detected", &MonitorScore::trials_whole)
          .fixed("false_per_hour", "false alarms", "1/h", 1, &MonitorScore::false_per_hour)
          .answer()
          .fixed("false_share", "of the time", &MonitorScore::false_share)
          .fixed("alarms_per_hour", "alarms", "1/h", 1, &MonitorScore::alarms_per_hour)
          .fixed("median_delay_s", "delay, median", "s", 2, &MonitorScore::median_delay_s)
          .fixed("progress_lost", "progress under alarm", [](auto& m) { return m.progress.value; })
          .answer()
          .table("monitors", "What each rule sees, and what it costs", assurance.monitors);
  table.footnotes = {
      "An episode is detected by an alarm that is on at some time from 2 s before its beginning to "
      "0.5 s after it; a false alarm is a piece of an alarm outside of all times from 2 s before "
      "an episode to 0.5 s "
      "after it, and 'of the time' is how long they are. 'any' is all rules together.",
      "Progress under alarm: share of the way forward that was driven while it was on; an alarm "
      "that is always on detects everything and costs all of it.",
      fmt::format("Intervals: {:g} %, days resampled (expanded percentiles); none with fewer than "
                  "10 days.",
                  100.0 * assurance.options.level)};
  return table;
}

Table faults_table(const study::Assurance& assurance) {
  Table table =
      ColumnsOf<FaultScore>()
          .text("kind", "fault", &FaultScore::kind)
          .text("monitor", "rule", &FaultScore::monitor)
          .integer("faults", "injected", [](auto& f) { return f.faults.of; })
          .integer("alarmed", "alarmed", [](auto& f) { return f.faults.found; })
          .estimate("share", "share", "", 3, [](auto& f) { return estimated(f.faults); })
          .answer()
          .estimate(
              "without", "without a fault", "", 3, [](auto& f) { return estimated(f.controls); })
          .answer()
          .fixed("median_delay_s", "delay, median", "s", 2, &FaultScore::median_delay_s)
          .table("faults", "Which injected faults are seen", assurance.faults);
  table.footnotes = {
      "A fault is seen by an alarm that is on at some time from its beginning to 0.5 s after its "
      "end; "
      "'without a fault' is how often one is on in a time as long, 5 s and more before it, which "
      "is what "
      "chance does. A fault need not make the robot unsafe."};
  return table;
}

Table risk_table(const study::Assurance& assurance) {
  using study::RiskBin;
  Table table = ColumnsOf<RiskBin>()
                    .fixed("from", "stated from", "", 1, &RiskBin::from)
                    .fixed("to", "to", "", 1, &RiskBin::to)
                    .integer("looks", "looks", [](auto& b) { return b.met.of; })
                    .fixed("mean_stated", "mean stated", "", 3, &RiskBin::mean_stated)
                    .estimate("met", "met a wall", "", 3, [](auto& b) { return estimated(b.met); })
                    .answer()
                    .table("risk", "Chance of a collision ahead: stated and met", assurance.risk);
  table.footnotes = {
      "A look a second: what the risk field states of the next risk_ahead_m straight on, and "
      "whether "
      "the body would have met a wall on it by the truth."};
  return table;
}

Table episodes_table(const std::vector<AssuredTrial>& trials) {
  struct Row {
    std::string trial_id;
    study::UnsafeEpisode episode;
    study::Detection by_any;
  };
  std::vector<Row> rows;
  for (const AssuredTrial& trial : trials) {
    for (std::size_t i = 0; i < trial.episodes.size(); ++i) {
      rows.push_back({trial.trial_id, trial.episodes[i], trial.monitors.back().episodes[i]});
    }
  }
  return ColumnsOf<Row>()
      .text("trial_id", "trial", &Row::trial_id)
      .fixed("begin_s", "begin", "s", 2, [](auto& r) { return r.episode.time.begin_s; })
      .fixed("end_s", "end", "s", 2, [](auto& r) { return r.episode.time.end_s; })
      .integer("ahead", "a wall ahead", [](auto& r) { return r.episode.ahead ? 1 : 0; })
      .integer("force", "a force", [](auto& r) { return r.episode.force ? 1 : 0; })
      .integer("detected", "detected", [](auto& r) { return r.by_any.detected ? 1 : 0; })
      .fixed("delay_s",
             "delay",
             "s",
             2,
             [](auto& r) {
               return r.by_any.detected ? std::optional(r.by_any.delay_s) : std::nullopt;
             })
      .table("episodes", "Unsafe episodes", rows);
}

Table alarms_table(const std::vector<AssuredTrial>& trials, const std::vector<std::string>& rules) {
  struct Row {
    std::string trial_id;
    std::string rule;
    study::TimeSpan time;
  };
  std::vector<Row> rows;
  for (const AssuredTrial& trial : trials) {
    for (std::size_t r = 0; r < rules.size(); ++r) {
      for (const study::TimeSpan& alarm : trial.monitors[r].alarms) {
        rows.push_back({trial.trial_id, rules[r], alarm});
      }
    }
  }
  return ColumnsOf<Row>()
      .text("trial_id", "trial", &Row::trial_id)
      .text("rule", "rule", &Row::rule)
      .fixed("begin_s", "begin", "s", 2, [](auto& r) { return r.time.begin_s; })
      .fixed("end_s", "end", "s", 2, [](auto& r) { return r.time.end_s; })
      .table("alarms", "Alarms", rows);
}

/// Of each kind of fault the rule that sees most of it beyond chance.
void add_faults(const study::Assurance& assurance, std::vector<Finding>& findings) {
  for (std::size_t i = 0; i < assurance.faults.size(); ++i) {
    if (assurance.faults[i].monitor != "any") {
      continue;
    }
    const std::string& kind = assurance.faults[i].kind;
    const auto beyond = [](const FaultScore& one) {
      return one.faults.value.value_or(0.0) - one.controls.value.value_or(0.0);
    };
    const FaultScore* best = &assurance.faults[i];
    for (std::size_t k = i + 1; k < assurance.faults.size() && assurance.faults[k].kind == kind;
         ++k) {
      const FaultScore& one = assurance.faults[k];
      best = best->monitor == "any" || beyond(one) > beyond(*best) ? &one : best;
    }
    findings.push_back(
        {"Fault '" + kind + "'",
         "",
         fmt::format("{} of {} injected are met by an alarm of '{}', {}; without a fault "
                     "{}.",
                     best->faults.found,
                     best->faults.of,
                     best->monitor,
                     in_words(best->faults.value, best->faults.interval),
                     in_words(best->controls.value, best->controls.interval))});
  }
}

Table findings_of_assurance(const study::Assurance& assurance) {
  const MonitorScore& any = assurance.monitors.back();
  if (assurance.without_truth == assurance.trials) {
    return findings_table(
        {{"Rules",
          "",
          fmt::format("{} alarms an hour over {} trials. Without logs/<trial_id>/truth.csv (tcert "
                      "drive --truth) nobody knows which of them are right.",
                      any.alarms_per_hour ? fmt::format("{:.1f}", *any.alarms_per_hour) : "NA",
                      assurance.trials)}});
  }
  const std::string claim =
      fmt::format("More than {:g} % of unsafe episodes detected", 100.0 * assurance.options.claim);
  const std::string evidence = fmt::format(
      "{} of {} unsafe episodes, {}; of {} trials that have one, {} without a miss; {} false "
      "alarms "
      "an hour; {} of the way forward is driven under an alarm.",
      any.episodes.found,
      any.episodes.of,
      in_words(any.episodes.value, any.episodes.interval),
      any.trials,
      any.trials_whole,
      any.false_per_hour ? fmt::format("{:.1f}", *any.false_per_hour) : "NA",
      any.progress.value ? fmt::format("{:.1f} %", 100.0 * *any.progress.value) : "NA");
  std::vector<Finding> findings{{claim, std::string(study::to_string(any.claim)), evidence}};
  add_faults(assurance, findings);
  return findings_table(findings,
                        {"Supported if the interval of the share lies above the claim, "
                         "contradicted if below it. With "
                         "95 % confidence a share above 90 % takes 29 episodes of independent "
                         "trials without a miss."});
}

Table summary_of(const study::Assurance& assurance) {
  Record record("summary", "The trials");
  record.integer("trials", "trials", assurance.trials)
      .integer("without_truth", "of them without truth.csv", assurance.without_truth)
      .integer("clusters", "days", assurance.clusters)
      .number("hours", "hours", assurance.hours);
  return std::move(record).table();
}

}  // namespace

FitReport assurance_report(const study::Assurance& assurance,
                           const std::vector<AssuredTrial>& trials,
                           const std::vector<std::string>& rules) {
  FitReport report;
  report.model = "assure monitor";
  report.findings = findings_of_assurance(assurance);
  report.summary = summary_of(assurance);
  report.tables = {monitors_table(assurance)};
  if (!assurance.risk.empty()) {
    report.tables.push_back(risk_table(assurance));
  }
  if (!assurance.faults.empty()) {
    report.tables.push_back(faults_table(assurance));
  }
  report.details = {episodes_table(trials), alarms_table(trials, rules)};
  return report;
}

}  // namespace tcert
