#include "analysis/study/coverage/gate_study.hpp"

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <array>
#include <cmath>
#include <optional>
#include <statistics/basics/quantile.hpp>
#include <stdexcept>
#include <tcert/certifier.hpp>

#include "analysis/study/gate/even_chance.hpp"
#include "analysis/study/gate/gate_pass.hpp"
#include "analysis/study/trials/certify_trial.hpp"
#include "datasets/corpus/micro_study.hpp"
#include "datasets/corpus/tentacles.hpp"
#include "datasets/trial_reader.hpp"

namespace tcert::study::coverage {
namespace {

constexpr std::array<const char*, kGateMethods> kGateMethodNames{
    "fieller", "profile", "bootstrap_percentile", "bootstrap_bca"};

GateCoverage coverage_of(std::size_t method, const std::vector<GateStudy>& all, double truth) {
  GateCoverage row;
  row.method = kGateMethodNames[method];
  std::vector<double> widths;
  for (const GateStudy& study : all) {
    const ConfidenceSet& set = study.sets[method];
    if (set.kind == ConfidenceSetKind::unknown) {
      continue;
    }
    ++row.sets;
    row.covered += set.covers(truth) ? 1.0 : 0.0;
    row.covered_zero += set.covers(0.0) ? 1.0 : 0.0;
    if (set.kind == ConfidenceSetKind::bounded) {
      widths.push_back(set.high - set.low);
    } else {
      ++row.unbounded;
    }
  }
  const auto count = static_cast<double>(row.sets);
  row.covered /= count;
  row.covered_zero /= count;
  row.monte_carlo_se = std::sqrt(row.covered * (1.0 - row.covered) / count);
  row.median_width_m = statistics::median(widths).value_or(std::nan(""));
  return row;
}

EvenChance pooled(const std::vector<GateStudy>& studies) {
  std::vector<double> margin;
  std::vector<std::uint8_t> success;
  for (const GateStudy& study : studies) {
    margin.insert(margin.end(), study.margin.begin(), study.margin.end());
    success.insert(success.end(), study.success.begin(), study.success.end());
  }
  EvenChanceOptions large;
  large.replicates = 0;
  return even_chance(margin, success, large);
}

}  // namespace

struct GateStudies::Certifiers {
  tbb::enumerable_thread_specific<Certifier> of_thread{[] {
    const Course course{Disc{{0.0, 0.0}, 0.3}, Disc{{3.4, 0.0}, 0.3}};
    return Certifier(corpus_robot(), course, {});
  }};
};

GateStudies::GateStudies(const GateOptions& options)
    : options_(options), certifiers_(std::make_unique<Certifiers>()) {}

GateStudies::~GateStudies() = default;

GateStudy GateStudies::operator()(std::uint64_t index) const {
  const std::uint64_t seed = options_.first_seed + index;
  GateStudy study;
  // While this thread's certifier is in use nothing here waits for other tasks, so that no work of
  // another study comes between.
  Certifier& certifier = certifiers_->of_thread.local();
  for (std::uint64_t i = 0; i < kGatePasses; ++i) {
    const SimulatedTrial trial = simulate_gate_pass(seed, i);
    const TrialSeries series = certify_trial(certifier, resample(trial.log));
    const GatePass pass = gate_pass(series.ticks, corpus_robot().body_width_m);
    study.margin.push_back(pass.bottleneck_m.value());
    study.success.push_back(trial.row.success.value() ? 1 : 0);
  }
  EvenChanceOptions even;
  even.level = options_.level;
  even.replicates = options_.replicates;
  even.seed = seed;
  const EvenChance found = even_chance(study.margin, study.success, even);
  study.point = found.point;
  study.sets = {found.fieller, found.profile, found.percentile, found.bca};
  return study;
}

GateSummary summarise(const std::vector<GateStudy>& studies) {
  const EvenChance truth = pooled(studies);
  if (!truth.point || !truth.slope) {
    throw std::domain_error("all micro-studies together have no 50 % point: there are too few");
  }
  GateSummary summary;
  summary.point_m = *truth.point;
  summary.point_error_m = (truth.fieller.high - truth.fieller.low) / (2.0 * 1.959963984540054);
  summary.slope_per_m = *truth.slope;
  std::vector<double> points;
  for (const GateStudy& study : studies) {
    if (study.point) {
      points.push_back(*study.point);
      summary.mean_estimate_m += *study.point;
    }
  }
  summary.separated = studies.size() - points.size();
  summary.mean_estimate_m /= static_cast<double>(points.size());
  summary.median_estimate_m = statistics::median(points).value_or(std::nan(""));
  for (std::size_t method = 0; method < kGateMethods; ++method) {
    summary.methods.push_back(coverage_of(method, studies, summary.point_m));
  }
  return summary;
}

}  // namespace tcert::study::coverage
