#include "reports/audit.hpp"

#include <array>
#include <cmath>
#include <string_view>
#include <table/csv_write.hpp>

#include "reports/table.hpp"

namespace tcert {
namespace {

struct Words {
  GuardTrigger trigger;
  std::string_view name;
};

constexpr std::array kWords = {Words{guard_margin, "margin"},
                               Words{guard_force, "G2_force"},
                               Words{guard_replan, "G3_replan"},
                               Words{guard_no_bound, "no_bound"},
                               Words{guard_no_evidence, "no_evidence"},
                               Words{guard_barrier, "barrier"}};

constexpr int kShownDecimals = 4;

struct Cause {
  double value = kMissing;
  double limit = kMissing;
  std::string text;
};

std::string compared(std::string_view what, double value, std::string_view how, double limit) {
  return std::string(what) + ' ' + fixed(value, kShownDecimals) + ' ' + std::string(how) + ' ' +
         fixed(limit, kShownDecimals);
}

Cause cause_of(GuardTrigger trigger,
               const CertifiedTick& certified,
               const GuardedTick& guarded,
               const GuardParameters& parameters) {
  switch (trigger) {
    case guard_margin:
      return {
          certified.margin_m, 0.0, compared("tick margin in m:", certified.margin_m, "of", 0.0)};
    case guard_force:
      return {guarded.force_n,
              guarded.force_limit_n,
              compared("tip force in N:", guarded.force_n, "of", guarded.force_limit_n)};
    case guard_replan:
      return {
          guarded.robust_margin_m,
          parameters.replan_margin_m,
          compared(
              "robust margin in m:", guarded.robust_margin_m, "of", parameters.replan_margin_m)};
    case guard_no_bound:
      return {kMissing, kMissing, "the tracking-error table ends below the speed or its change"};
    case guard_no_evidence:
      return {kMissing, kMissing, "the tick is stale or bad: no margin"};
    case guard_barrier:
      return {kMissing, kMissing, "no command keeps away from what was felt"};
  }
  return {};
}

void append_cell(std::string& out, double value) {
  out += ',';
  if (std::isfinite(value)) {
    table::append_number(out, value);
  }
}

}  // namespace

std::string audit_header() {
  return "time_s,guard,event,value,limit,cause,x_m,y_m,yaw_rad,speed_mps\n";
}

namespace {

/// One row: what began or ended, and where the robot was.
void append_row(std::string& out,
                const std::string& prefix,
                const Tick& tick,
                std::string_view name,
                bool began,
                const Cause& cause,
                double speed_mps) {
  out += prefix;
  table::append_seconds(out, tick.time_ns);
  out += ',';
  out += name;
  out += began ? ",begin" : ",end";
  append_cell(out, cause.value);
  append_cell(out, cause.limit);
  out += ',';
  table::append_text(out, cause.text);
  append_cell(out, tick.pose.position.x_m);
  append_cell(out, tick.pose.position.y_m);
  append_cell(out, tick.pose.yaw_rad);
  append_cell(out, speed_mps);
  out += '\n';
}

}  // namespace

void append_audit_rows(std::string& out,
                       const Tick& tick,
                       const CertifiedTick& certified,
                       const ActedTick& acted,
                       const GuardParameters& parameters,
                       const std::vector<std::string>& rules,
                       const std::string& prefix) {
  const GuardedTick& guarded = acted.guarded;
  for (const auto& [trigger, name] : kWords) {
    if (((guarded.began | guarded.ended) & trigger) != 0) {
      append_row(out,
                 prefix,
                 tick,
                 name,
                 (guarded.began & trigger) != 0,
                 cause_of(trigger, certified, guarded, parameters),
                 guarded.speed_mps);
    }
  }
  for (std::size_t r = 0; r < rules.size(); ++r) {
    const std::uint32_t rule = 1U << r;
    if (((acted.alarms_began | acted.alarms_ended) & rule) != 0) {
      append_row(out,
                 prefix,
                 tick,
                 "rule_" + rules[r],
                 (acted.alarms_began & rule) != 0,
                 {kMissing,
                  kMissing,
                  (acted.alarms_began & rule) != 0 ? "the rule holds" : "the rule holds no longer"},
                 guarded.speed_mps);
    }
  }
}

std::string words_of_signals(std::uint32_t signals) {
  std::string words;
  for (std::size_t k = 0; k < kTickSignals; ++k) {
    if ((signals & (1U << k)) != 0) {
      words += (words.empty() ? "" : ", ") + std::string(tick_signals()[k].name);
    }
  }
  return words;
}

std::string alarm_words(std::uint32_t alarms, const std::vector<std::string>& rules) {
  std::string words;
  for (std::size_t r = 0; r < rules.size(); ++r) {
    if ((alarms & (1U << r)) != 0) {
      words += (words.empty() ? "" : "+") + rules[r];
    }
  }
  return words;
}

std::string trigger_words(std::uint32_t triggers) {
  std::string words;
  for (const auto& [trigger, name] : kWords) {
    if ((triggers & trigger) != 0) {
      words += words.empty() ? "" : "+";
      words += name;
    }
  }
  return words;
}

}  // namespace tcert
