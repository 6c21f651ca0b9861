#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <tcert/rule_monitor.hpp>

#include "support/allocations.hpp"

namespace tcert {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

SignalValues signals(double force_n, double width_m) {
  SignalValues values{};
  values[*signal_named("force_n")] = force_n;
  values[*signal_named("width_m")] = width_m;
  return values;
}

std::vector<double> robustness(const std::string& formula) {
  RuleMonitor monitor(parse_rules("rule: " + formula));
  const std::vector<double> a{100, -1, -2, 5, -1};
  const std::vector<double> b{20, -2, 10, 4, -1};
  std::vector<double> found;
  for (std::size_t i = 0; i < a.size(); ++i) {
    monitor.update(static_cast<std::int64_t>(i) * 1'000'000'000, signals(a[i], b[i]));
    EXPECT_EQ(monitor.states()[0].robustness.low, monitor.states()[0].robustness.high);
    found.push_back(monitor.states()[0].robustness.low);
  }
  return found;
}

// By hand, on two signals at five instants one second apart.
TEST(RuleMonitor, HasTheRobustnessOfPastTimeLogic) {
  using Values = std::vector<double>;
  EXPECT_EQ(robustness("historically force_n > 0"), (Values{100, -1, -2, -2, -2}));
  EXPECT_EQ(robustness("once[0,1] force_n > 0"), (Values{100, 100, -1, 5, 5}));
  EXPECT_EQ(robustness("once[1,2] force_n > 0"), (Values{-kInf, 100, 100, -1, 5}));
  EXPECT_EQ(robustness("historically[1,2] force_n > 0"), (Values{kInf, 100, -1, -2, -2}));
  EXPECT_EQ(robustness("force_n > 0 since width_m > 0"), (Values{20, -1, 10, 5, -1}));
  EXPECT_EQ(robustness("not force_n > 0"), (Values{-100, 1, 2, -5, 1}));
  EXPECT_EQ(robustness("force_n > 0 and width_m > 0"), (Values{20, -2, -2, 4, -1}));
  EXPECT_EQ(robustness("force_n > 0 or width_m > 0"), (Values{100, -1, 10, 5, -1}));
  EXPECT_EQ(robustness("2*force_n - width_m >= 3"), (Values{177, -3, -17, 3, -4}));
  EXPECT_EQ(robustness("force_n < 3 + width_m"), (Values{-77, 2, 15, 2, 3}));
  EXPECT_EQ(robustness("once[1,inf] force_n > 0"), (Values{-kInf, 100, 100, 100, 100}));
}

// Every window by looking at all that came before.
TEST(RuleMonitor, WindowsAreThoseOfASlowReference) {
  std::mt19937 random(9);
  std::normal_distribution<double> value;
  std::uniform_int_distribution<std::int64_t> step(10'000'000, 300'000'000);
  for (int trial = 0; trial < 60; ++trial) {
    const double from = 0.1 * (trial % 5);
    const double to = from + 0.25 * (trial % 7);
    const bool largest = trial % 2 == 0;
    const std::string window = "[" + to_text(from) + "," + to_text(to) + "]";
    RuleMonitor monitor(parse_rules("r: " + std::string(largest ? "once" : "historically") +
                                    window + " force_n > 0"));
    std::vector<std::pair<std::int64_t, double>> past;
    std::int64_t now_ns = 0;
    for (int i = 0; i < 300; ++i) {
      now_ns += step(random);
      past.emplace_back(now_ns, value(random));
      double expected = largest ? -kInf : kInf;
      for (const auto& [time_ns, v] : past) {
        const auto ago_ns = static_cast<double>(now_ns - time_ns);
        if (ago_ns >= std::round(from * 1e9) && ago_ns <= std::round(to * 1e9)) {
          expected = largest ? std::max(expected, v) : std::min(expected, v);
        }
      }
      monitor.update(now_ns, signals(past.back().second, 0.0));
      ASSERT_EQ(monitor.states()[0].robustness.low, expected) << window << ' ' << i;
    }
  }
}

TEST(RuleMonitor, WhatIsMissingMayBeAnything) {
  RuleMonitor monitor(
      parse_rules("above: force_n > 1\n"
                  "not_above: not force_n > 1\n"
                  "either: force_n > 1 or width_m > 0\n"
                  "gone: missing(force_n)\n"
                  "lately: once[0,1] force_n > 1\n"));
  EXPECT_EQ(monitor.update(0, signals(std::nan(""), 1.0)), 0b01100U);
  EXPECT_EQ(monitor.update(500'000'000, signals(2.0, -1.0)), 0b10101U);
  EXPECT_EQ(monitor.update(1'000'000'000, signals(std::nan(""), -1.0)), 0b11000U);
}

TEST(RuleMonitor, SaysWhichSignalsNeverCame) {
  RuleMonitor monitor(parse_rules("a: force_n > 1 or width_m > 1\nb: missing(margin_m)"));
  monitor.update(0, signals(std::nan(""), 1.0));
  EXPECT_EQ(monitor.never_known(), 1U << *signal_named("force_n"));
  monitor.update(1, signals(2.0, 1.0));
  EXPECT_EQ(monitor.never_known(), 0U);
}

TEST(RuleMonitor, ATickOutOfOrderChangesNothing) {
  RuleMonitor monitor(parse_rules("r: once[0,1] force_n > 0"));
  EXPECT_EQ(monitor.update(10, signals(1.0, 0.0)), 1U);
  EXPECT_EQ(monitor.update(5, signals(-1.0, 0.0)), 1U);
  monitor.reset();
  EXPECT_EQ(monitor.update(5, signals(-1.0, 0.0)), 0U);
}

TEST(RuleMonitor, AllocatesNothingHoweverFastTicksCome) {
  RuleMonitor monitor(parse_rules(default_rules()));
  const std::size_t before = test_support::allocation_count();
  for (std::int64_t i = 0; i < 20'000; ++i) {
    monitor.update(i * 1'000'000, signals(std::sin(0.01 * static_cast<double>(i)), 0.0));
  }
  EXPECT_EQ(test_support::allocation_count(), before);
}

void expect_refused(const std::string& rules, const std::string& message) {
  try {
    static_cast<void>(parse_rules(rules));
    ADD_FAILURE() << rules;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

TEST(ParseRules, SaysWhereAndWhatItExpected) {
  expect_refused("a: forse_n > 1", "line 1, column 4: found 'forse_n', expected a signal: time_s");
  expect_refused("# comment\n\na: force_n 1", "line 3, column 12: found '1', expected <, <=, >");
  expect_refused("a: (force_n > 1", "found the end, expected ')'");
  expect_refused("a: once[2,1] force_n > 1", "a window [from, to]");
  expect_refused("a: once[0,601] force_n > 1", "a window [from, to]");
  expect_refused("a: force_n > 1\na: force_n > 2",
                 "line 2, column 1: found 'a', expected each name");
  expect_refused("a force_n > 1", "expected ':'");
  expect_refused("a: force_n > 1 force_n > 2", "and, or, since");
  expect_refused("watch: force_n > 1", "expected the name of a rule");
  expect_refused("any: force_n > 1", "expected the name of a rule");
  std::string sum = "a: force_n";
  std::string windows;
  for (int i = 0; i < 40; ++i) {
    sum += " + force_n";
    windows += (i == 0 ? "a: " : " or ") + std::string("once[0,600] force_n > 1");
  }
  expect_refused(sum + " > 1", "a sum of at most 32 signals");
  expect_refused(windows, "windows of at most 6000 s");
  expect_refused(std::string(100'000, ' '), "expected at most 65536");
  expect_refused("a: " + std::string(200, '(') + "force_n > 1", "at most 64 parts");
  std::string many;
  for (int i = 0; i < 33; ++i) {
    many += "r" + std::to_string(i) + ": force_n > 1\n";
  }
  expect_refused(many, "at most 32 rules");
}

TEST(ParseRules, TakesTheDefaultRules) {
  const std::vector<Rule> rules = parse_rules(default_rules());
  ASSERT_EQ(rules.size(), 8U);
  EXPECT_EQ(rules[2].name, "force");
  EXPECT_EQ(rules[2].text, "force_n > force_limit_n");
  EXPECT_TRUE(parse_rules("").empty());
  EXPECT_FALSE(rules[3].acts) << "margin is watched";
  EXPECT_EQ(RuleMonitor(rules).acting(), 0b11100101U);
}

}  // namespace
}  // namespace tcert
