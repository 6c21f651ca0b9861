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
                               Words{guard_no_evidence, "no_evidence"}};

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

void append_audit_rows(std::string& out,
                       const Tick& tick,
                       const CertifiedTick& certified,
                       const GuardedTick& guarded,
                       const GuardParameters& parameters,
                       const std::string& prefix) {
  if ((guarded.began | guarded.ended) == 0) {
    return;
  }
  for (const auto& [trigger, name] : kWords) {
    if (((guarded.began | guarded.ended) & trigger) == 0) {
      continue;
    }
    const Cause cause = cause_of(trigger, certified, guarded, parameters);
    out += prefix;
    table::append_seconds(out, tick.time_ns);
    out += ',';
    out += name;
    out += (guarded.began & trigger) != 0 ? ",begin" : ",end";
    append_cell(out, cause.value);
    append_cell(out, cause.limit);
    out += ',';
    table::append_text(out, cause.text);
    append_cell(out, tick.pose.position.x_m);
    append_cell(out, tick.pose.position.y_m);
    append_cell(out, tick.pose.yaw_rad);
    append_cell(out, guarded.speed_mps);
    out += '\n';
  }
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
