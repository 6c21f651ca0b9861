#include "analysis/study/coverage/gate_study.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <optional>
#include <statistics/basics/quantile.hpp>
#include <tcert/certifier.hpp>

#include "analysis/study/gate/even_chance.hpp"
#include "analysis/study/gate/gate_pass.hpp"
#include "analysis/study/trials/certify_trial.hpp"
#include "datasets/corpus/micro_study.hpp"
#include "datasets/corpus/tentacles.hpp"
#include "datasets/trial_reader.hpp"

namespace tcert::study::coverage {
namespace {

using Range = tbb::blocked_range<std::size_t>;

struct Passes {
  std::vector<double> margin;
  std::vector<std::uint8_t> success;
};

Passes simulate_study(Certifier& certifier, std::uint64_t seed) {
  Passes passes;
  for (std::uint64_t i = 0; i < kGatePasses; ++i) {
    const SimulatedTrial trial = simulate_gate_pass(seed, i);
    const TrialSeries series = certify_trial(certifier, resample(trial.log));
    const GatePass pass = gate_pass(series.ticks, corpus_robot().body_width_m);
    passes.margin.push_back(pass.bottleneck_m.value());
    passes.success.push_back(trial.row.success.value() ? 1 : 0);
  }
  return passes;
}

struct Method {
  const char* name;
  ConfidenceSet EvenChance::*set;
};

constexpr std::array kGateMethods = {Method{"fieller", &EvenChance::fieller},
                                     Method{"profile", &EvenChance::profile},
                                     Method{"bootstrap_percentile", &EvenChance::percentile},
                                     Method{"bootstrap_bca", &EvenChance::bca}};

GateCoverage coverage_of(const Method& method, const std::vector<EvenChance>& all, double truth) {
  GateCoverage row;
  row.method = method.name;
  std::vector<double> widths;
  for (const EvenChance& even : all) {
    const ConfidenceSet& set = even.*method.set;
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

Passes pooled(const std::vector<Passes>& studies) {
  Passes all;
  for (const Passes& study : studies) {
    all.margin.insert(all.margin.end(), study.margin.begin(), study.margin.end());
    all.success.insert(all.success.end(), study.success.begin(), study.success.end());
  }
  return all;
}

}  // namespace

GateSummary run_gates(const GateOptions& options, const Watch& watch) {
  const Course course{Disc{{0.0, 0.0}, 0.3}, Disc{{3.4, 0.0}, 0.3}};
  tbb::enumerable_thread_specific<Certifier> certifiers(
      [&] { return Certifier(corpus_robot(), course, {}); });
  std::vector<Passes> studies(options.studies);
  std::vector<EvenChance> found(options.studies);
  watch.begin("micro-studies, passes", options.studies);
  tbb::parallel_for(Range(0, options.studies, 1), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      // No work of another study may come between while this thread's certifier is in use: nothing
      // in here waits for other tasks.
      studies[i] = simulate_study(certifiers.local(), options.first_seed + i);
      watch.advance();
    }
  });
  watch.begin("micro-studies, sets", options.studies);
  tbb::parallel_for(Range(0, options.studies, 1), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      EvenChanceOptions even;
      even.level = options.level;
      even.replicates = options.replicates;
      even.seed = options.first_seed + i;
      found[i] = even_chance(studies[i].margin, studies[i].success, even);
      watch.advance();
    }
  });
  const Passes all = pooled(studies);
  EvenChanceOptions large;
  large.replicates = 0;
  const EvenChance truth = even_chance(all.margin, all.success, large);
  GateSummary summary;
  summary.point_m = truth.point.value();
  summary.point_error_m = (truth.fieller.high - truth.fieller.low) / (2.0 * 1.959963984540054);
  summary.slope_per_m = truth.slope.value();
  std::vector<double> points;
  for (const EvenChance& even : found) {
    if (even.point) {
      points.push_back(*even.point);
      summary.mean_estimate_m += *even.point;
    }
  }
  summary.separated = options.studies - points.size();
  summary.mean_estimate_m /= static_cast<double>(points.size());
  summary.median_estimate_m = statistics::median(points).value_or(std::nan(""));
  for (const Method& method : kGateMethods) {
    summary.methods.push_back(coverage_of(method, found, summary.point_m));
  }
  return summary;
}

}  // namespace tcert::study::coverage
