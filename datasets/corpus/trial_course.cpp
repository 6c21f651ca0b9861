#include "datasets/corpus/trial_course.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <table/random.hpp>
#include <tcert/elementary.hpp>

#include "datasets/corpus/purpose.hpp"
#include "datasets/corpus/tentacles.hpp"

namespace tcert {
namespace {

constexpr double kNominalLaneWidth = 1.2;
constexpr double kLeastRadius = 0.6;
constexpr double kMostRadius = 1.0;

constexpr double kMeanLevel = 0.090;    // margin of a success's gates
constexpr double kOutcomeStep = 0.047;  // how much less a failure's are, at effect 1
constexpr double kDaySd = 0.029;        // of the lanes' width, from day to day
constexpr double kTrialSd = 0.026;      // of the level, from trial to trial
constexpr double kGateSd = 0.008;       // from gate to gate
constexpr double kSecondGate = 0.020;   // how much wider a lane's second gate is, at least
constexpr double kLeastMargin = 0.020;
constexpr double kSoftness = 0.010;

constexpr double kWedgeMargin = -0.025;
constexpr double kWedgeSd = 0.006;
constexpr double kLeastWedge = 0.008;

constexpr double kFirstGateFrom = 0.68;
constexpr double kFirstGateTo = 0.90;
constexpr double kGateSpacing = 0.50;
constexpr double kLastGate = 1.50;
constexpr double kWallClearance = 0.12;  // a gate's middle before the wall's end
constexpr double kMostOffset = 0.02;

/// log(1 + e^x) keeps order and is above 0: a floor without a heap of equal values on it.
double softly_above(double value, double floor) {
  return floor + kSoftness * elementary::log(1.0 + elementary::exp((value - floor) / kSoftness));
}

void add_gates(TrialCourse& trial,
               Lane lane,
               double tightest_width,
               table::RandomStream& course_random,
               table::RandomStream& tightness_random) {
  int i = 0;
  for (Gate& gate : place_gates(trial.course, lane, course_random)) {
    gate.width_m =
        tightest_width + i * (kSecondGate + kGateSd * std::abs(tightness_random.normal()));
    trial.gates.push_back(gate);
    ++i;
  }
}

/// Makes one of the gates of the route's second lane too narrow.
void add_wedge(TrialCourse& trial, double shift, table::RandomStream& random) {
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < trial.gates.size(); ++i) {
    if (trial.gates[i].lane == trial.route.second) {
      candidates.push_back(i);
    }
  }
  trial.wedge = candidates[random.below(static_cast<std::uint32_t>(candidates.size()))];
  const double margin = kWedgeMargin + shift + kWedgeSd * random.normal();
  trial.gates[*trial.wedge].width_m =
      corpus_robot().body_width_m - softly_above(-margin, kLeastWedge);
}

double least_margin(const TrialCourse& trial) {
  double least = std::numeric_limits<double>::infinity();
  for (const Gate& gate : trial.gates) {
    if (gate.lane == trial.route.first || gate.lane == trial.route.second) {
      least = std::min(least, gate.width_m - corpus_robot().body_width_m);
    }
  }
  return least;
}

}  // namespace

FigureEight draw_lanes(double shift_m, table::RandomStream& random) {
  return {random.uniform(kLeastRadius, kMostRadius), kNominalLaneWidth + shift_m};
}

std::vector<Gate> place_gates(const FigureEight& course, Lane lane, table::RandomStream& random) {
  const double end = std::min(kLastGate, walled_length(course) - kWallClearance);
  const double first = random.uniform(kFirstGateFrom, std::min(kFirstGateTo, end));
  const double spacing = kGateSpacing + 0.2 * random.uniform();
  const bool two = random.uniform() < 0.6 && first + spacing <= end;
  std::vector<Gate> gates(two ? 2 : 1);
  double along = first;
  for (Gate& gate : gates) {
    gate.lane = lane;
    gate.along_m = along;
    gate.offset_m = random.uniform(-kMostOffset, kMostOffset);
    gate.length_m = random.uniform(0.10, 0.20);
    along = first + spacing;
  }
  return gates;
}

TrialCourse draw_course(const TrialDesign& design) {
  table::RandomStream course_random(design.seed, draws::kCourse, design.index);
  table::RandomStream tightness_random(design.seed, draws::kTightness, design.index);
  table::RandomStream wedge_random(design.seed, draws::kWedge, design.index);
  const double shift = kDaySd * design.day_level;
  const double level = kMeanLevel - (design.success ? 0.0 : kOutcomeStep * design.effect) + shift +
                       kTrialSd * tightness_random.normal();
  TrialCourse trial;
  trial.course = draw_lanes(shift, course_random);
  trial.route.first = {false, course_random.below(2) == 0};
  trial.route.second = {true, course_random.below(2) == 0};
  for (const bool at_goal : {false, true}) {
    for (const bool upper : {false, true}) {
      const double margin = softly_above(level + kGateSd * tightness_random.normal(), kLeastMargin);
      add_gates(trial,
                {at_goal, upper},
                corpus_robot().body_width_m + margin,
                course_random,
                tightness_random);
    }
  }
  if (!design.success) {
    add_wedge(trial, shift, wedge_random);
  }
  trial.true_margin_m = least_margin(trial);
  return trial;
}

}  // namespace tcert
