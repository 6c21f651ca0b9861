#include "reports/audit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tcert {
namespace {

Tick tick_at(std::int64_t time_ns) { return {time_ns, {{1.5, -0.25}, 0.5}, {}, false, false}; }

TEST(AuditRows, NameWhatBeganAndWhatEnded) {
  CertifiedTick certified;
  certified.margin_m = -0.0125;
  GuardedTick guarded;
  guarded.robust_margin_m = 0.25;
  guarded.began = guard_margin;
  guarded.ended = guard_replan;
  GuardParameters parameters;
  parameters.replan_margin_m = 0.0625;
  std::string rows;
  append_audit_rows(rows, tick_at(2'500'000'000), certified, {guarded}, parameters);
  EXPECT_EQ(rows,
            "2.5,margin,begin,-0.0125,0,tick margin in m: -0.0125 of 0.0000,1.5,-0.25,0.5,0\n"
            "2.5,G3_replan,end,0.25,0.0625,robust margin in m: 0.2500 of 0.0625,1.5,-0.25,0.5,0\n");
}

TEST(AuditRows, AreNoneWhileNothingChanges) {
  GuardedTick guarded;
  guarded.triggers = guard_replan;
  std::string rows;
  append_audit_rows(rows, tick_at(0), {}, {guarded}, {});
  EXPECT_TRUE(rows.empty());
}

TEST(AuditRows, HaveTheColumnsOfTheHeader) {
  GuardedTick guarded;
  guarded.began = guard_margin | guard_force | guard_replan | guard_no_bound | guard_no_evidence;
  std::string rows;
  append_audit_rows(rows, tick_at(0), {}, {guarded}, {}, {}, "t1,");
  const std::string header = audit_header();
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 5);
  EXPECT_EQ(std::count(rows.begin(), rows.end(), ','),
            5 * (1 + std::count(header.begin(), header.end(), ',')));
  EXPECT_EQ(trigger_words(guarded.began), "margin+G2_force+G3_replan+no_bound+no_evidence");
}

TEST(AuditLog, SaysWhichRuleBeganAndEnded) {
  ActedTick acted;
  acted.alarms_began = 0b10U;
  acted.alarms_ended = 0b01U;
  std::string rows;
  append_audit_rows(rows, tick_at(0), {}, acted, {}, {"stall", "force"}, "t1,");
  EXPECT_NE(rows.find("t1,0,rule_stall,end,"), std::string::npos) << rows;
  EXPECT_NE(rows.find("t1,0,rule_force,begin,"), std::string::npos) << rows;
  EXPECT_EQ(alarm_words(0b11U, {"stall", "force"}), "stall+force");
  EXPECT_EQ(alarm_words(0U, {"stall", "force"}), "");
}

}  // namespace
}  // namespace tcert
