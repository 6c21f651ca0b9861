#include <statistics/survival/cumulative_incidence.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <statistics/survival/survival_curve.hpp>
#include <stdexcept>
#include <string>
#include <table/random.hpp>
#include <vector>

#include "analysis/statistics/worst.hpp"

namespace tcert::statistics {
namespace {

using nlohmann::json;

const std::vector<std::string> kCauses{"egress", "failure"};

TEST(CumulativeIncidence, AddsUpByHand) {
  // Four rows: egress at 1, failure at 2, censored at 2, egress at 3. P(egress) = 1/4, then
  // S(2) = 3/4 (1 - 1/3) = 1/2, P(failure) = 3/4 * 1/3 = 1/4; at 3 one is left: P(egress) = 3/4.
  const CompetingOutcome outcome{{}, {1, 2, 2, 3}, {1, 2, 0, 1}, kCauses};
  const IncidenceCurves curves = cumulative_incidence(outcome)[0];
  EXPECT_EQ(curves.time, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(curves.at_risk, (std::vector<double>{4, 3, 1}));
  EXPECT_EQ(curves.censored, (std::vector<double>{0, 1, 0}));
  EXPECT_EQ(curves.causes[0].probability, (std::vector<double>{0.25, 0.25, 0.75}));
  EXPECT_EQ(curves.causes[1].probability, (std::vector<double>{0.0, 0.25, 0.25}));
  EXPECT_EQ(curves.event_free.probability, (std::vector<double>{0.75, 0.5, 0.0}));
  // A share of rows without censoring before: binomial variance.
  EXPECT_NEAR(curves.causes[0].std_error[0], std::sqrt(0.25 * 0.75 / 4.0), 1e-15);
  EXPECT_EQ(curves.index_at(0.5), 3U);
  EXPECT_EQ(curves.index_at(2.5), 1U);
}

TEST(CumulativeIncidence, NamesWhatItCannotEstimate) {
  const table::Factor groups{{1, 1}, {"none", "some"}};
  IncidenceOptions options;
  options.groups = &groups;
  const auto curves = cumulative_incidence({{}, {1, 2}, {0, 0}, kCauses}, options);
  EXPECT_TRUE(has(curves[0].conditions, ConditionKind::no_rows));
  EXPECT_TRUE(has(curves[1].conditions, ConditionKind::no_events));
  EXPECT_THROW(static_cast<void>(cumulative_incidence({{}, {1, 2}, {0, 3}, kCauses})),
               std::invalid_argument);
  EXPECT_THROW(static_cast<void>(cumulative_incidence({{}, {1}, {0, 1}, kCauses})),
               std::invalid_argument);
}

struct Case {
  CompetingOutcome outcome;
  std::vector<double> weights;
  table::Factor cluster;
};

Case random_case(std::uint64_t index) {
  table::RandomStream random(21, 1, index);
  Case rows;
  rows.outcome.causes = kCauses;
  rows.cluster.levels = {"a", "b", "c", "d", "e"};
  for (std::size_t row = 0; row < 30; ++row) {
    rows.outcome.start.push_back(index % 2 == 0 ? 0.0 : random.below(3));
    rows.outcome.stop.push_back(rows.outcome.start.back() + 1.0 + random.below(8));
    rows.outcome.cause.push_back(random.below(3));
    rows.weights.push_back(0.5 + random.uniform());
    rows.cluster.codes.push_back(random.below(5));
  }
  return rows;
}

std::vector<double> values_of(const Case& rows, std::size_t cause) {
  IncidenceOptions options;
  options.weights = rows.weights;
  return cumulative_incidence(rows.outcome, options)[0].causes[cause].probability;
}

TEST(CumulativeIncidence, HasTheVarianceOfItsNumericalDerivatives) {
  for (std::uint64_t index = 0; index < 6; ++index) {
    const Case rows = random_case(index);
    IncidenceOptions options;
    options.weights = rows.weights;
    options.cluster = &rows.cluster;
    const IncidenceCurves curves = cumulative_incidence(rows.outcome, options)[0];
    for (std::size_t cause = 0; cause < 2; ++cause) {
      std::vector<std::vector<double>> influence(5, std::vector<double>(curves.time.size(), 0.0));
      for (std::size_t row = 0; row < rows.weights.size(); ++row) {
        constexpr double kStep = 1e-5;
        Case more = rows;
        Case less = rows;
        more.weights[row] += kStep;
        less.weights[row] -= kStep;
        const std::vector<double> up = values_of(more, cause);
        const std::vector<double> down = values_of(less, cause);
        for (std::size_t k = 0; k < up.size(); ++k) {
          influence[rows.cluster.codes[row]][k] +=
              rows.weights[row] * (up[k] - down[k]) / (2.0 * kStep);
        }
      }
      for (std::size_t k = 0; k < curves.time.size(); ++k) {
        double variance = 0.0;
        for (const auto& cluster : influence) {
          variance += cluster[k] * cluster[k];
        }
        EXPECT_NEAR(curves.causes[cause].std_error[k], std::sqrt(variance), 1e-8);
      }
    }
  }
}

TEST(CumulativeIncidence, OfOneCauseIsKaplanMeier) {
  Case rows = random_case(1);
  for (auto& cause : rows.outcome.cause) {
    cause = std::min<std::uint32_t>(cause, 1);
  }
  SurvivalOutcome outcome{rows.outcome.start, rows.outcome.stop, {}};
  for (const std::uint32_t cause : rows.outcome.cause) {
    outcome.event.push_back(static_cast<std::uint8_t>(cause));
  }
  IncidenceOptions options;
  options.weights = rows.weights;
  CurveOptions curve_options;
  curve_options.weights = rows.weights;
  const IncidenceCurves curves = cumulative_incidence(rows.outcome, options)[0];
  const SurvivalCurve curve = survival_curves(outcome, curve_options)[0];
  for (std::size_t k = 0; k < curve.points.size(); ++k) {
    EXPECT_NEAR(curves.causes[0].probability[k], 1.0 - curve.points[k].survival, 1e-14);
    EXPECT_NEAR(curves.event_free.std_error[k], curve.points[k].std_error(), 1e-14);
    EXPECT_NEAR(curves.causes[0].std_error[k], curve.points[k].std_error(), 1e-13);
  }
}

table::Factor factor_of(const std::vector<std::string>& names) {
  std::map<std::string, std::uint32_t> codes;
  for (const std::string& name : names) {
    codes[name] = 0;
  }
  table::Factor factor;
  for (auto& [name, code] : codes) {
    code = static_cast<std::uint32_t>(factor.levels.size());
    factor.levels.push_back(name);
  }
  for (const std::string& name : names) {
    factor.codes.push_back(codes.at(name));
  }
  return factor;
}

TEST(CumulativeIncidence, EqualsSurvfit) {
  std::ifstream file(std::string(TCERT_GOLDEN) + "/aalen_johansen.json");
  ASSERT_TRUE(file);
  const json golden = json::parse(file);
  Worst worst(1e-10);
  std::size_t cases = 0;
  for (const auto& [name, expected] : golden["cases"].items()) {
    SCOPED_TRACE(name);
    const json& data = golden["data"][expected["data"].get<std::string>()];
    CompetingOutcome outcome{{},
                             data["stop"].get<std::vector<double>>(),
                             data["cause"].get<std::vector<std::uint32_t>>(),
                             kCauses};
    if (expected["data"] == "truncated") {
      outcome.start = data["start"].get<std::vector<double>>();
    }
    const table::Factor groups = factor_of(data["group"].get<std::vector<std::string>>());
    const table::Factor days = factor_of(data["day"].get<std::vector<std::string>>());
    const auto weights = data["weight"].get<std::vector<double>>();
    IncidenceOptions options;
    options.groups = &groups;
    if (expected["weighted"].get<bool>()) {
      options.weights = weights;
    }
    options.cluster = expected["clustered"].get<bool>() ? &days : nullptr;
    for (const IncidenceCurves& curves : cumulative_incidence(outcome, options)) {
      const json& values = expected["groups"][curves.group];
      ASSERT_EQ(curves.time.size(), values["time"].size());
      for (std::size_t k = 0; k < curves.time.size(); ++k) {
        worst.expect("time", curves.time[k], values["time"][k]);
        if (values.contains("n_risk")) {  // R counts rows there, not their weight
          worst.expect("n.risk", curves.at_risk[k], values["n_risk"][k]);
          worst.expect("n.censor", curves.censored[k], values["n_censor"][k]);
        }
        const IncidenceCurve* const states[] = {
            &curves.event_free, &curves.causes[0], &curves.causes[1]};
        for (std::size_t s = 0; s < 3; ++s) {
          if (values.contains("n_event")) {
            worst.expect("n.event", states[s]->events[k], values["n_event"][k][s]);
          }
          worst.expect("pstate (absolute)", states[s]->probability[k], values["pstate"][k][s], 1.0);
          worst.expect("std.err (absolute)", states[s]->std_error[k], values["std_err"][k][s], 1.0);
        }
      }
    }
    ++cases;
  }
  std::printf("Aalen-Johansen golden cases run: %zu\n", cases);
  worst.print();
  EXPECT_GT(cases, 0U);
}

TEST(CumulativeIncidence, ARiskSetThatEmptiesLeavesNoRounding) {
  // 0.3 + 0.5 + 1.9 less the last is no 0 in floating point; at 4 everybody at risk leaves. By R
  // 4.2.2 the standard error of the event-free state is 0 from then on and that of 'egress' stays.
  CompetingOutcome outcome{{0, 3, 2, 0}, {2, 5, 4, 2}, {2, 1, 1, 1}, kCauses};
  const std::vector<double> weights{0.3, 1.8, 1.9, 0.5};
  IncidenceOptions options;
  options.weights = weights;
  const IncidenceCurves curves = cumulative_incidence(outcome, options)[0];
  EXPECT_EQ(curves.event_free.probability[0], 0.0);  // at 2 both at risk fail or egress
  for (std::size_t k = 0; k < curves.time.size(); ++k) {
    EXPECT_NEAR(curves.causes[0].std_error[k], 0.33145630368119417, 1e-12);
    EXPECT_NEAR(curves.causes[0].probability[k], 0.625, 1e-14);
  }
}

}  // namespace
}  // namespace tcert::statistics
