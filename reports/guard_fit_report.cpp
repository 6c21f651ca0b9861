#include "reports/guard_fit_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <table/csv_write.hpp>

#include "analysis/study/replay/replay_record.hpp"
#include "reports/columns_of.hpp"
#include "reports/findings.hpp"

namespace tcert {
namespace {

using study::GuardChoice;
using study::GuardDwell;
using study::GuardFit;
using study::GuardFold;
using study::GuardScore;

constexpr double kPer100 = 100.0;  // m

/// A choice with what came of it, beside the unguarded robot on the same ways.
struct GuardRow {
  const GuardChoice* choice = nullptr;
  GuardDwell guarded;
  GuardDwell unguarded;
  std::size_t fold = 0;
  std::size_t days = 0;
};

double progress_share(const GuardRow& row) {
  return row.guarded.metres_per_minute() / row.unguarded.metres_per_minute();
}

/// NA where the guards do not act.
std::optional<double> of_acting(const GuardRow& row, double value) {
  return row.choice->guards.mode == GuardMode::act ? std::optional(value) : std::nullopt;
}

void add_choice_columns(ColumnsOf<GuardRow>& columns) {
  columns
      .text("speed_law",
            "law",
            [](auto& r) { return std::string(study::to_string(r.choice->law.kind)); })
      .fixed("beta_per_m", "beta", "1/m", 1, [](auto& r) { return r.choice->law.beta_per_m; })
      .fixed("replan_margin_m",
             "epsilon",
             "m",
             4,
             [](auto& r) { return of_acting(r, r.choice->guards.replan_margin_m); })
      .fixed("guard_min_force_n", "F_min", "N", 1, [](auto& r) {
        return of_acting(r, r.choice->guards.min_force_n);
      });
}

void add_outcome_columns(ColumnsOf<GuardRow>& columns) {
  columns
      .fixed("unsafe_s_per_100m",
             "unsafe, s per 100 m",
             [](auto& r) { return kPer100 * r.guarded.unsafe_per_metre(); })
      .answer()
      .fixed("unguarded_s_per_100m",
             "unguarded",
             [](auto& r) { return kPer100 * r.unguarded.unsafe_per_metre(); })
      .fixed("progress_m_per_min",
             "progress",
             "m/min",
             2,
             [](auto& r) { return r.guarded.metres_per_minute(); })
      .fixed("progress_share", "of the unguarded", progress_share)
      .answer()
      .fixed("stalled_share", "trials stalled", [](auto& r) { return r.guarded.stalled_share(); })
      .answer();
}

Table choices_table(const char* name, const char* title, const GuardFit& fit, bool front_alone) {
  std::vector<GuardRow> rows;
  for (const GuardScore& score : fit.scores) {
    if (score.on_front || !front_alone) {
      rows.push_back({&fit.choices[score.choice], score.all, fit.unguarded});
    }
  }
  std::ranges::stable_sort(
      rows, {}, [](const GuardRow& r) { return -r.guarded.metres_per_minute(); });
  ColumnsOf<GuardRow> columns;
  add_choice_columns(columns);
  add_outcome_columns(columns);
  return columns.table(name, title, rows);
}

Table folds_table(const GuardFit& fit) {
  std::vector<GuardRow> rows;
  for (std::size_t k = 0; k < fit.folds.size(); ++k) {
    const GuardFold& fold = fit.folds[k];
    rows.push_back({&fit.choices[fold.choice], fold.guarded, fold.unguarded, k + 1, fold.days});
  }
  ColumnsOf<GuardRow> columns;
  columns.integer("fold", "fold", &GuardRow::fold).integer("days", "days", &GuardRow::days);
  add_choice_columns(columns);
  add_outcome_columns(columns);
  Table table = columns.table("guard_folds", "Chosen on other days, judged on these", rows);
  table.footnotes = {"Folds of whole days: what is printed of a fold had no part in its choice."};
  return table;
}

Table risk_table(const GuardFit& fit) {
  struct Row {
    double epsilon_m;
    double risk;
  };
  std::vector<Row> rows;
  for (const auto& [epsilon_m, risk] : fit.control.risk) {
    rows.push_back({epsilon_m, risk});
  }
  Table table = ColumnsOf<Row>()
                    .fixed("replan_margin_m", "epsilon", "m", 4, &Row::epsilon_m)
                    .fixed("risk", "unsafe share of a day's time", "", 4, &Row::risk)
                    .table("guard_risk", "Conformal risk control of epsilon", rows);
  table.footnotes = {
      "The smallest epsilon with n/(n + 1) R + 1/(n + 1) <= alpha keeps the expected unsafe share "
      "of a "
      "new day at alpha or below, if days are exchangeable: of guards that act under the law, beta "
      "and "
      "F_min of the parameters, for what is chosen by the same days has no such promise."};
  return table;
}

std::string config_of(const GuardChoice& choice, const std::string& tracking_error) {
  std::string text = "# What 'tcert calibrate guards' chose; --config takes it as it is.\n";
  if (!tracking_error.empty()) {
    text += "# Chosen with --tracking-error '" + tracking_error + "': it belongs to it.\n";
  }
  const auto line = [&](const char* key, double value) {
    text += std::string(key) + " = ";
    table::append_number(text, value);
    text += '\n';
  };
  text += "speed_law = " + std::string(study::to_string(choice.law.kind)) + '\n';
  line("beta_per_m", choice.law.beta_per_m);
  if (choice.guards.mode == GuardMode::act) {
    text += "guard_mode = act\n";
    line("replan_margin_m", choice.guards.replan_margin_m);
    line("guard_min_force_n", choice.guards.min_force_n);
  } else {
    text += "guard_mode = watch\n";
  }
  return text;
}

GuardDwell held_out(const GuardFit& fit, bool guarded) {
  GuardDwell sum;
  for (const GuardFold& fold : fit.folds) {
    sum += guarded ? fold.guarded : fold.unguarded;
  }
  return sum;
}

Table findings_of_guards(const GuardFit& fit, const study::GuardFitOptions& options) {
  std::vector<Finding> findings;
  if (fit.best && !fit.folds.empty()) {
    const GuardDwell before = held_out(fit, false);
    const GuardDwell after = held_out(fit, true);
    findings.push_back(
        {"Guards",
         "",
         fmt::format(
             "On days that had no part in the choice the guarded robot is unsafe for {:.2f} s "
             "per 100 m, the unguarded one for {:.2f}, at {:.1f} % of its progress; {} of {} "
             "trials stall.{}",
             kPer100 * after.unsafe_per_metre(),
             kPer100 * before.unsafe_per_metre(),
             100.0 * after.metres_per_minute() / before.metres_per_minute(),
             after.stalled,
             after.trials,
             fit.folds_without == 0
                 ? ""
                 : fmt::format(" {} folds are left out: no choice of the other days was good "
                               "enough.",
                               fit.folds_without))});
  } else {
    findings.push_back(
        {"Guards",
         "",
         fmt::format("No choice of {} keeps {:g} % of the unguarded progress and lets no "
                     "more than {:g} % of the trials stall.",
                     fit.choices.size(),
                     100.0 * (1.0 - options.most_lost),
                     100.0 * options.most_lost)});
  }
  const std::string declared = fmt::format("{} at {:g} per metre, F_min {:g} N, as declared",
                                           study::to_string(options.declared.law.kind),
                                           options.declared.law.beta_per_m,
                                           options.declared.guards.min_force_n);
  findings.push_back(
      {"epsilon",
       "",
       fit.control.risk.empty()
           ? fmt::format("Nothing is promised: {} is not in the lists.", declared)
       : fit.control.epsilon_m
           ? fmt::format(
                 "epsilon {:g} m keeps the expected unsafe share of a new day at {:g} or below "
                 "({}).",
                 *fit.control.epsilon_m,
                 options.risk,
                 declared)
           : fmt::format(
                 "No epsilon of the lists promises an unsafe share of {:g} ({}); with {} days "
                 "nothing below {:.3g} can be promised.",
                 options.risk,
                 declared,
                 fit.days,
                 fit.control.least_alpha)});
  return findings_table(findings,
                        {"Where guards halt, the way is driven at the least speed and counts as "
                         "safe; a trial stalls if "
                         "that goes on over stall_m: it would not have got through. What a robot "
                         "does after a halt is "
                         "measured by 'tcert drive' with +guards."});
}

}  // namespace

FitReport guard_fit_report(const GuardFit& fit,
                           const study::GuardFitOptions& options,
                           const std::string& tracking_error) {
  FitReport report;
  report.model = "calibrate guards";
  report.findings = findings_of_guards(fit, options);
  Record record("summary", "The fit");
  record.integer("choices", "choices", fit.choices.size())
      .integer("days", "days", fit.days)
      .number("most_lost", "progress that may be lost", options.most_lost)
      .number("risk", "alpha of epsilon", options.risk)
      .number("least_alpha", "least alpha that so many days promise", fit.control.least_alpha);
  report.summary = std::move(record).table();
  report.tables = {choices_table(
      "guard_front", "No other has more progress, less dwell and fewer stalls", fit, true)};
  if (!fit.folds.empty()) {
    report.tables.push_back(folds_table(fit));
  }
  if (!fit.control.risk.empty()) {
    report.tables.push_back(risk_table(fit));
  }
  report.details = {choices_table("guard_choices", "Every choice", fit, false)};
  if (fit.best) {
    report.attachments = {
        {"guards", "For --config:", config_of(fit.choices[*fit.best], tracking_error), "ini"}};
  }
  return report;
}

}  // namespace tcert
