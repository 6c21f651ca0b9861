// What the corpus's features are like, beside each other and beside what drives them. Bounds are
// reasoned beforehand; what is found is printed, and stands in datasets/corpus/README.md.

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <statistics/roc/roc.hpp>
#include <string>
#include <utility>
#include <vector>

#include "analysis/study/trials/certify_trial.hpp"
#include "analysis/study/trials/features.hpp"
#include "datasets/corpus/corpus.hpp"
#include "support/correlation.hpp"

namespace tcert::study {
namespace {

enum Column : std::size_t {
  tc_early,
  contacts_per_m,
  dwell,
  bend_variance,
  features,
  speed = features,
  way,
  duration,
  contacts,        // that began in the first 15 s
  contacts_all_m,  // that began in the whole trial, per metre
  columns
};
constexpr std::array<const char*, columns> kNames{"tc_early",
                                                  "contacts_per_m",
                                                  "dwell",
                                                  "bend_variance",
                                                  "speed",
                                                  "distance",
                                                  "duration",
                                                  "contacts in 15 s",
                                                  "contacts per m of all"};
constexpr std::array<statistics::HigherMeans, features> kHigher{statistics::HigherMeans::success,
                                                                statistics::HigherMeans::failure,
                                                                statistics::HigherMeans::failure,
                                                                statistics::HigherMeans::failure};

struct Study {
  std::array<std::vector<double>, columns> column;
  std::vector<double> success;
  std::vector<std::uint32_t> day;
  std::vector<std::pair<Algorithm, Lighting>> cell;
};

void summarise(const TrialDesign& design, std::size_t row, Study& study) {
  const SimulatedTrial trial = simulate_trial(design);
  const BundleInfo info = corpus_info({});
  Certifier certifier(info.robot, info.course, {});
  const TickTable ticks = resample(trial.log);
  const TrialSeries series = certify_trial(certifier, ticks);
  const Features found = early_features(info.robot, ticks, series.ticks);
  double begun = 0.0;
  double begun_early = 0.0;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    begun += series.ticks[i].new_contacts;
    begun_early +=
        ticks.time_ns[i] - ticks.time_ns[0] <= 15'000'000'000 ? series.ticks[i].new_contacts : 0;
  }
  study.column[tc_early][row] = found.tc_landmark.value();
  study.column[contacts_per_m][row] = found.contacts_per_m_landmark.value();
  study.column[dwell][row] = found.dwell_landmark.value();
  study.column[bend_variance][row] = found.bend_variance_landmark.value();
  study.column[speed][row] = trial.row.distance_m.value() / trial.row.time_s.value();
  study.column[way][row] = trial.row.distance_m.value();
  study.column[duration][row] = trial.row.time_s.value();
  study.column[contacts][row] = begun_early;
  study.column[contacts_all_m][row] = begun / found.travel_m.value();
  study.success[row] = design.success ? 1.0 : 0.0;
  study.day[row] = static_cast<std::uint32_t>(design.day);
  study.cell[row] = {design.algorithm, design.lighting};
}

Study study_of(std::uint64_t seed, std::uint64_t noise_seed) {
  CorpusOptions options;
  options.seed = seed;
  std::vector<TrialDesign> designs = design_block(options, 0);
  Study study;
  for (auto& column : study.column) {
    column.resize(designs.size());
  }
  study.success.resize(designs.size());
  study.day.resize(designs.size());
  study.cell.resize(designs.size());
  tbb::parallel_for(std::size_t{0}, designs.size(), [&](std::size_t i) {
    designs[i].noise_seed = noise_seed;
    summarise(designs[i], i, study);
  });
  return study;
}

const Study& default_study() {
  static const Study kStudy = study_of(1, 1);
  return kStudy;
}

/// Ranks from 1, tied values at their mean.
std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
  std::vector<double> rank(values.size());
  for (std::size_t i = 0; i < order.size();) {
    std::size_t j = i;
    while (j < order.size() && values[order[j]] == values[order[i]]) {
      ++j;
    }
    for (std::size_t k = i; k < j; ++k) {
      rank[order[k]] = 0.5 * static_cast<double>(i + j + 1);
    }
    i = j;
  }
  return rank;
}

/// Spearman's, ties at mean ranks.
double rho(const Study& study, Column a, Column b) {
  return test_support::correlation(ranks(study.column[a]), ranks(study.column[b]));
}

/// The same with ranks taken within algorithm and lighting, as shares of the cell.
double rho_within_cells(const Study& study, Column a, Column b) {
  std::map<std::pair<Algorithm, Lighting>, std::vector<std::size_t>> cells;
  for (std::size_t i = 0; i < study.cell.size(); ++i) {
    cells[study.cell[i]].push_back(i);
  }
  std::array<std::vector<double>, 2> shares;
  for (auto& share : shares) {
    share.resize(study.cell.size());
  }
  for (const auto& [cell, rows] : cells) {
    for (std::size_t side = 0; side < 2; ++side) {
      std::vector<double> values;
      for (const std::size_t row : rows) {
        values.push_back(study.column[side == 0 ? a : b][row]);
      }
      const std::vector<double> rank = ranks(values);
      for (std::size_t i = 0; i < rows.size(); ++i) {
        shares[side][rows[i]] = (rank[i] - 0.5) / static_cast<double>(rows.size());
      }
    }
  }
  return test_support::correlation(shares[0], shares[1]);
}

void print_histogram(const Study& study, Column column, double width, std::size_t classes) {
  const auto& values = study.column[column];
  const auto [least, most] = std::ranges::minmax(values);
  std::printf(
      "%s: %.4g to %.4g, mean %.4g\n",
      kNames[column],
      least,
      most,
      std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size()));
  std::vector<std::size_t> counts(classes);
  for (const double value : values) {
    ++counts[std::min(static_cast<std::size_t>(std::max(value / width, 0.0)), classes - 1)];
  }
  for (std::size_t k = 0; k < classes; ++k) {
    std::printf("  %s%6.3f %4zu %s\n",
                k + 1 == classes ? ">=" : "  ",
                width * static_cast<double>(k),
                counts[k],
                std::string(counts[k] / 5, '#').c_str());
  }
}

// Physical limits: a gate begins at most two contacts (and the frontal tentacle one at a jaw), two
// gates and the start of a lane lie in the first 15 s of 1.2 m or more, so at most some five a
// metre, and every trial feels its first gate on both sides. A robot stands for up to 1 s at the
// start and 1.5 s at a contact, of 15 s. A bend moves between 0 and 1.2 rad: a gate at half of it
// for a sixth of the time makes 0.05 rad^2 in a lateral tentacle, nothing in the frontal one.
TEST(CorpusFeatures, LieWithinWhatTheCourseAllows) {
  const Study& study = default_study();
  print_histogram(study, contacts_per_m, 0.25, 15);
  print_histogram(study, dwell, 0.01, 15);
  print_histogram(study, bend_variance, 0.01, 12);
  const auto range = [&](Column column) { return std::ranges::minmax(study.column[column]); };
  EXPECT_GE(range(contacts).min, 2.0);
  EXPECT_LE(range(contacts_per_m).max, 5.0);
  EXPECT_GE(range(dwell).min, 0.0);
  EXPECT_LE(range(dwell).max, 0.35);
  EXPECT_GT(range(bend_variance).min, 0.0);
  EXPECT_LT(range(bend_variance).max, 0.15);
  for (const Column column : {contacts_per_m, dwell, bend_variance}) {
    std::vector<double> sorted = study.column[column];
    std::ranges::sort(sorted);
    const std::size_t n = sorted.size();
    EXPECT_GT(sorted[9 * n / 10], 1.5 * sorted[n / 10]) << kNames[column] << " hardly varies";
  }
}

// A feature that goes with speed, way or duration at |rho| >= 0.5 would be a clock in disguise.
// One does, and why: the gates of a lane stand in its first 1.5 m, which all but the slowest robots
// drive in 15 s, so that what TC_early sees does not depend on speed. Hence contacts in 15 s do not
// either, but the metres that they are divided by do.
TEST(CorpusFeatures, AreNoFunctionOfSpeedWayOrDuration) {
  const Study& study = default_study();
  std::printf("%-22s %22s %22s %22s\n", "rho (within cells)", "speed", "distance", "duration");
  for (std::size_t a = 0; a < columns; ++a) {
    if (a >= speed && a <= duration) {
      continue;
    }
    std::printf("%-22s", kNames[a]);
    for (const Column b : {speed, way, duration}) {
      std::printf(
          "        %6.3f (%6.3f)", rho(study, Column(a), b), rho_within_cells(study, Column(a), b));
    }
    std::printf("\n");
  }
  for (const Column a : {tc_early, contacts_per_m, dwell, bend_variance}) {
    for (const Column b : {speed, way, duration}) {
      const bool divided_by_way = a == contacts_per_m && b != way;
      EXPECT_LT(std::abs(rho(study, a, b)), divided_by_way ? 0.65 : 0.5)
          << kNames[a] << ", " << kNames[b];
      EXPECT_LT(std::abs(rho_within_cells(study, a, b)), 0.5) << kNames[a] << ", " << kNames[b];
    }
  }
  for (const Column a : {contacts, contacts_all_m}) {
    EXPECT_LT(std::abs(rho(study, a, speed)), 0.3) << kNames[a];
  }
}

// Contacts and the moving of tentacles are made by the same gates: they go together, but neither is
// the other.
TEST(CorpusFeatures, AreNoFunctionOfEachOther) {
  const Study& study = default_study();
  for (std::size_t a = 0; a < features; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const double r = rho(study, Column(a), Column(b));
      std::printf("rho of %s and %s: %.3f\n", kNames[a], kNames[b], r);
      EXPECT_LT(std::abs(r), 0.9) << kNames[a] << ", " << kNames[b];
    }
  }
}

statistics::JointAuc aucs(const Study& study) {
  std::vector<statistics::Score> scores;
  for (std::size_t k = 0; k < features; ++k) {
    scores.push_back({study.column[k], kHigher[k]});
  }
  statistics::AucOptions options;
  options.cluster = study.day;
  return statistics::joint_auc(scores, study.success, options);
}

// The same drives with other noise and other clocks: each AUC within its standard error. Another
// study altogether: within three standard errors of the difference.
TEST(CorpusFeatures, HaveTheSameAucsWhateverTheNoise) {
  const statistics::JointAuc first = aucs(default_study());
  const statistics::JointAuc noise = aucs(study_of(1, 2));
  const statistics::JointAuc other = aucs(study_of(2, 2));
  for (std::size_t k = 0; k < features; ++k) {
    const auto value = [k](const statistics::JointAuc& joint) {
      return joint.markers[k].auc.value();
    };
    const auto error = [k](const statistics::JointAuc& joint) {
      return std::sqrt(joint.markers[k].variance.value());
    };
    std::printf("AUC of %-15s %.3f (%.3f), other noise %.3f (%.3f), other study %.3f (%.3f)\n",
                kNames[k],
                value(first),
                error(first),
                value(noise),
                error(noise),
                value(other),
                error(other));
    EXPECT_LT(std::abs(value(first) - value(noise)), error(first)) << kNames[k];
    EXPECT_LT(std::abs(value(first) - value(other)), 3.0 * std::hypot(error(first), error(other)))
        << kNames[k];
  }
}

}  // namespace
}  // namespace tcert::study
