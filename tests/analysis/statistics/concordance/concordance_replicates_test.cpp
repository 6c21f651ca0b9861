#include <statistics/concordance/concordance_replicates.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

struct Rows {
  SurvivalOutcome outcome;
  std::vector<double> x;
  table::Factor strata;
};

Rows random_rows(std::size_t n, std::uint32_t values) {
  table::RandomStream random(11, 1, n);
  Rows rows;
  rows.strata.levels = {"a", "b"};
  for (std::size_t row = 0; row < n; ++row) {
    rows.outcome.start.push_back(random.below(values));
    rows.outcome.stop.push_back(rows.outcome.start.back() + 1.0 + random.below(values));
    rows.outcome.event.push_back(random.below(4) == 0 ? 0 : 1);
    rows.x.push_back(random.below(values));
    rows.strata.codes.push_back(random.below(2));
  }
  return rows;
}

void expect_same_as_weights(const SurvivalOutcome& outcome,
                            const Predictor& predictor,
                            const table::Factor* strata) {
  const ConcordanceReplicates replicates(outcome, predictor, strata);
  ConcordanceReplicates::Scratch scratch;
  const std::vector<std::uint32_t> once(outcome.rows(), 1);
  ConcordanceOptions options;
  options.strata = strata;
  const std::vector<Predictor> predictors{predictor};
  EXPECT_EQ(replicates.c(once, scratch),
            concordance(outcome, predictors, options).estimates[0].c.value());

  table::RandomStream random(12, 1, outcome.rows());
  for (int replicate = 0; replicate < 20; ++replicate) {
    std::vector<std::uint32_t> times(outcome.rows(), 0);
    for (std::size_t draw = 0; draw < outcome.rows(); ++draw) {
      ++times[random.below(static_cast<std::uint32_t>(outcome.rows()))];
    }
    const std::vector<double> weights(times.begin(), times.end());
    options.weights = weights;
    EXPECT_EQ(replicates.c(times, scratch),
              concordance(outcome, predictors, options).estimates[0].c.value());
  }
}

TEST(ConcordanceReplicates, EqualTheEstimateWithCaseWeightsToTheLastBit) {
  for (const std::uint32_t values : {5U, 40U, 5000U}) {
    Rows rows = random_rows(400, values);
    for (const LargerMeans larger : {LargerMeans::longer_time, LargerMeans::shorter_time}) {
      expect_same_as_weights(rows.outcome, {"x", rows.x, larger}, nullptr);
      expect_same_as_weights(rows.outcome, {"x", rows.x, larger}, &rows.strata);
    }
    rows.outcome.start.assign(400, 0.0);
    expect_same_as_weights(rows.outcome, {"x", rows.x}, nullptr);
    rows.outcome.start.clear();
    expect_same_as_weights(rows.outcome, {"x", rows.x}, nullptr);
    expect_same_as_weights(rows.outcome, {"x", rows.x}, &rows.strata);
  }
}

TEST(ConcordanceReplicates, ServesOneScratchToSeveralPredictors) {
  const Rows many = random_rows(300, 100);
  const Rows few = random_rows(50, 3);
  const ConcordanceReplicates first(many.outcome, {"many", many.x});
  const ConcordanceReplicates second(few.outcome, {"few", few.x});
  ConcordanceReplicates::Scratch shared;
  ConcordanceReplicates::Scratch own;
  const std::vector<std::uint32_t> a(300, 2);
  const std::vector<std::uint32_t> b(50, 3);
  const double one = first.c(a, shared);
  EXPECT_EQ(second.c(b, shared), second.c(b, own));
  EXPECT_EQ(first.c(a, shared), one);
}

TEST(ConcordanceReplicates, HasNoValueWithoutAComparablePair) {
  const SurvivalOutcome outcome{{}, {1, 2, 3}, {1, 0, 0}};
  const std::vector<double> x{1, 2, 3};
  const ConcordanceReplicates replicates(outcome, {"x", x});
  ConcordanceReplicates::Scratch scratch;
  EXPECT_TRUE(std::isnan(replicates.c(std::vector<std::uint32_t>{0, 2, 1}, scratch)));
  EXPECT_EQ(replicates.c(std::vector<std::uint32_t>{1, 2, 0}, scratch), 1.0);
  EXPECT_THROW(static_cast<void>(replicates.c(std::vector<std::uint32_t>{1}, scratch)),
               std::invalid_argument);
}

}  // namespace
}  // namespace tcert::statistics
