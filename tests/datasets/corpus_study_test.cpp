// The whole default corpus: what is published must come out, and what is declared must hold.

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tcert/certifier.hpp>
#include <vector>

#include "datasets/corpus/corpus.hpp"

namespace tcert {
namespace {

struct TrialSummary {
  TrialDesign design;
  double true_margin_m = 0.0;
  std::vector<double> speeds;
  std::vector<double> latencies;
  bool issued = false;
  std::size_t ticks = 0;
  std::size_t across_heading = 0;
  double least_early_value = 0.0;  // of tc_t in the first 15 s
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

TrialSummary summarise(const TrialDesign& design) {
  const SimulatedTrial trial = simulate_trial(design);
  TrialSummary summary;
  summary.design = design;
  summary.true_margin_m = trial.true_margin_m;
  summary.latencies = trial.log.control.loop_latency_ms;
  for (const double speed : trial.log.control.speed_cmd_mps) {
    summary.speeds.push_back(std::abs(speed));
  }
  const BundleInfo info = corpus_info({});
  Certifier certifier(info.robot, info.course, {});
  const TickTable ticks = resample(trial.log);
  summary.least_early_value = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const CertifiedTick tick = certifier.update(ticks[i]);
    summary.issued = tick.issued;
    ++summary.ticks;
    summary.across_heading += (tick.flags & flag_across_heading) != 0 ? 1 : 0;
    if (ticks.time_ns[i] - ticks.time_ns[0] <= 15'000'000'000 && !ticks.stale[i]) {
      summary.least_early_value = std::min(summary.least_early_value, series_value(tick));
    }
  }
  return summary;
}

const std::vector<TrialSummary>& default_study() {
  static const std::vector<TrialSummary> kStudy = [] {
    const auto designs = design_block({}, 0);
    std::vector<TrialSummary> study(designs.size());
    tbb::parallel_for(
        std::size_t{0}, designs.size(), [&](std::size_t i) { study[i] = summarise(designs[i]); });
    return study;
  }();
  return kStudy;
}

/// Over the control rows of all trials that `take` takes.
template <class Take>
double median_speed(Take take) {
  std::vector<double> speeds;
  for (const TrialSummary& trial : default_study()) {
    if (take(trial.design)) {
      speeds.insert(speeds.end(), trial.speeds.begin(), trial.speeds.end());
    }
  }
  return median(std::move(speeds));
}

TEST(DefaultCorpus, LandsOnThePublishedSpeedsOfEachAlgorithm) {
  const std::map<Algorithm, double> published{{Algorithm::cb_v, 0.19},
                                              {Algorithm::td_lite, 0.18},
                                              {Algorithm::m1, 0.175},
                                              {Algorithm::tvfh, 0.17},
                                              {Algorithm::m3, 0.135},
                                              {Algorithm::m2, 0.12}};
  std::map<Algorithm, double> found;
  for (const auto& [algorithm, speed] : published) {
    found[algorithm] = median_speed(
        [wanted = algorithm](const TrialDesign& design) { return design.algorithm == wanted; });
    EXPECT_NEAR(found[algorithm], speed, 0.01) << name_of(algorithm);
  }
  EXPECT_GT(found[Algorithm::cb_v], found[Algorithm::td_lite]);
  EXPECT_GE(found[Algorithm::td_lite], found[Algorithm::m1]);
  EXPECT_GE(found[Algorithm::m1], found[Algorithm::tvfh]);
  EXPECT_GT(found[Algorithm::tvfh], found[Algorithm::m3]);
  EXPECT_GT(found[Algorithm::m3], found[Algorithm::m2]);
}

TEST(DefaultCorpus, IsFastestIndoorsAndSlowestInTheDark) {
  const auto tier = [](Lighting lighting) {
    return median_speed([=](const TrialDesign& design) { return design.lighting == lighting; });
  };
  EXPECT_GT(tier(Lighting::indoor), tier(Lighting::outdoor));
  EXPECT_GT(tier(Lighting::outdoor), tier(Lighting::dark));
}

TEST(DefaultCorpus, HasTheSameLoopLatencyInEveryCell) {
  for (const Cell& cell : table_of_cells()) {
    std::vector<double> latencies;
    for (const TrialSummary& trial : default_study()) {
      if (trial.design.algorithm == cell.algorithm && trial.design.lighting == cell.lighting) {
        latencies.insert(latencies.end(), trial.latencies.begin(), trial.latencies.end());
      }
    }
    EXPECT_NEAR(median(std::move(latencies)), 19.6, 0.1);
  }
}

TEST(DefaultCorpus, IsCertifiedInMostSuccessesAndInHardlyAnyFailure) {
  int successes = 0;
  int failures = 0;
  for (const TrialSummary& trial : default_study()) {
    (trial.design.success ? successes : failures) += trial.issued ? 1 : 0;
  }
  EXPECT_GE(successes, 554);  // 95 % of 583
  EXPECT_LE(failures, 2);
}

// A robot that can only drive and turn slips where it is wedged, and nowhere else.
TEST(DefaultCorpus, MovesAlongItsHeadingButWhereItIsWedged) {
  std::size_t ticks = 0;
  std::size_t across = 0;
  for (const TrialSummary& trial : default_study()) {
    ticks += trial.ticks;
    across += trial.across_heading;
    EXPECT_TRUE(!trial.design.success || trial.across_heading == 0);
  }
  EXPECT_LT(static_cast<double>(across), 0.01 * static_cast<double>(ticks));
}

TEST(DefaultCorpus, HasAnEarlyCertificateInEveryTrial) {
  for (const TrialSummary& trial : default_study()) {
    EXPECT_TRUE(std::isfinite(trial.least_early_value)) << trial.design.index;
  }
}

// One-way analysis of variance with 30 trials in each of 22 days.
TEST(DefaultCorpus, HasTheDeclaredIntraclassCorrelationByDay) {
  std::array<double, kDaysPerBlock> means{};
  double grand = 0.0;
  for (const TrialSummary& trial : default_study()) {
    means[trial.design.day] += trial.true_margin_m / kTrialsPerDay;
    grand += trial.true_margin_m / kTrialsPerBlock;
  }
  double between = 0.0;
  double within = 0.0;
  for (const double mean : means) {
    between += kTrialsPerDay * (mean - grand) * (mean - grand);
  }
  for (const TrialSummary& trial : default_study()) {
    within += std::pow(trial.true_margin_m - means[trial.design.day], 2);
  }
  between /= kDaysPerBlock - 1;
  within /= kTrialsPerBlock - kDaysPerBlock;
  const double correlation = (between - within) / (between + (kTrialsPerDay - 1) * within);
  EXPECT_GE(correlation, 0.2);
  EXPECT_LE(correlation, 0.4);
}

}  // namespace
}  // namespace tcert
