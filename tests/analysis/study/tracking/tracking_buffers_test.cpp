#include "analysis/study/tracking/tracking_buffers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tcert::study {
namespace {

/// On a circle of `nominal_m`, driven on one of `driven_m` about the same centre, `late_s` behind,
/// at 0.2 m/s of the nominal one, every 0.1 s.
TrackingRun circle(double nominal_m, double driven_m, double late_s) {
  TrackingRun run{"r", "", {}};
  for (int i = 0; i <= 400; ++i) {
    const double time = 0.1 * i;
    const double planned = 0.2 * time / nominal_m;
    const double driven = 0.2 * (time - late_s) / nominal_m;
    run.samples.push_back({time,
                           {{driven_m * std::cos(driven), driven_m * std::sin(driven)},
                            driven + std::numbers::pi / 2},
                           {nominal_m * std::cos(planned), nominal_m * std::sin(planned)}});
  }
  return run;
}

TEST(TrackingBuffers, TellDistanceAndCurvatureOfCircles) {
  TrackingRuns runs;
  runs.runs = {circle(2.0, 2.0, 0.0), circle(2.0, 2.03, 1.0)};
  const TrackingBuffers buffers = tracking_buffers(runs, {});
  EXPECT_NEAR(buffers.runs[0].path_m, 0.0, 1e-12);
  EXPECT_NEAR(*buffers.runs[0].curvature_per_m, 0.0, 2e-4) << "chords are shorter than arcs";
  // 0.03 m outside, but for the sagitta of a step of 2 cm; at the first sample the path has not
  // begun.
  EXPECT_NEAR(
      buffers.runs[1].path_m, std::hypot(2.03 * std::sin(0.1), 2.03 * std::cos(0.1) - 2.0), 1e-6);
  EXPECT_EQ(buffers.runs[1].path_time_s, 0.0);
  EXPECT_NEAR(buffers.runs[1].same_time_m,
              std::hypot(2.03 * std::sin(0.1), 2.03 * std::cos(0.1) - 2.0),
              1e-9);
  EXPECT_NEAR(*buffers.runs[1].curvature_per_m, 1.0 / 2.0 - 1.0 / 2.03, 3e-4);
  EXPECT_NEAR(*buffers.runs[1].excess_per_m, 0.0, 3e-4) << "it turns less than it was to";
  EXPECT_EQ(buffers.path_m, buffers.runs[1].path_m);
  EXPECT_EQ(buffers.curvature_per_m, buffers.runs[1].curvature_per_m);

  TrackingRuns tight;
  tight.runs = {circle(2.0, 1.0, 0.0)};
  const RunErrors errors = tracking_buffers(tight, {}).runs[0];
  EXPECT_LE(errors.path_m, 1.0);
  EXPECT_GT(errors.path_m, 1.0 - 2.6e-5) << "the sagitta of a chord of 2 cm, 0.02^2 / 16";
  EXPECT_NEAR(*errors.excess_per_m, 0.5, 1e-3);
  EXPECT_LE(*errors.excess_per_m, *errors.curvature_per_m);
  EXPECT_NEAR(errors.travel_m, 4.0, 0.02);
}

// Out along y = 0, back along y = 0.2: who drives out along y = 0.2 is 0.2 m off, though the path
// comes by there later. Told beside a search through the whole polyline.
TEST(TrackingBuffers, DoNotTakeALaterStretchOfThePathForThisOne) {
  TrackingRun run{"r", "", {}};
  for (int i = 0; i <= 400; ++i) {
    const double time = 0.1 * i;
    const bool out = time <= 20.0;
    const Point nominal{out ? 0.2 * time : 0.2 * (40.0 - time), out ? 0.0 : 0.2};
    run.samples.push_back({time, {{nominal.x_m, 0.2}, 0.0}, nominal});
  }
  TrackingRuns runs;
  runs.runs = {run};
  TrackingOptions options;
  EXPECT_NEAR(tracking_buffers(runs, options).path_m, 0.2, 1e-12);
  options.lag_s = 60.0;
  EXPECT_LT(tracking_buffers(runs, options).path_m, 0.02) << "a step, where the path turns back";
  options.lag_s = 0.0;
  const TrackingBuffers at_once = tracking_buffers(runs, options);
  EXPECT_EQ(at_once.path_m, at_once.same_time_m);
}

TEST(TrackingBuffers, TakeCurvaturesThatAreStatedAndLeaveOutRunsThatAreTooShort) {
  TrackingRuns runs;
  runs.runs = {circle(2.0, 2.0, 0.0)};
  runs.has_curvature = true;
  runs.has_nominal_curvature = true;
  for (TrackedSample& sample : runs.runs[0].samples) {
    sample.nominal_curvature_per_m = 0.5;
    sample.curvature_per_m = sample.time_s == 1.0 ? -0.7 : 0.5;
  }
  const RunErrors errors = tracking_buffers(runs, {}).runs[0];
  EXPECT_DOUBLE_EQ(*errors.curvature_per_m, 1.2);
  EXPECT_NEAR(*errors.excess_per_m, 0.2, 1e-12);
  EXPECT_EQ(errors.curvature_time_s, 1.0);
  TrackingRuns none;
  none.runs = {{"r", "", {{0.0, {}, {}}, {1.0, {{0.1, 0.0}, 0.0}, {0.1, 0.0}}}}};
  EXPECT_FALSE(tracking_buffers(none, {}).curvature_per_m.has_value());
  EXPECT_EQ(tracking_buffers(none, {}).without_curvature, 1U);
}

// R: 1 - 0.95^59, 1 - 0.95^58, 0.05^(1/59).
TEST(Wilks, TakesFiftyNineRuns) {
  EXPECT_NEAR(wilks_confidence(59, 0.95), 0.951505474750577, 1e-12);
  EXPECT_NEAR(wilks_confidence(58, 0.95), 0.948953131316397, 1e-12);
  EXPECT_NEAR(wilks_share(59, 0.95), 0.950492390111773, 1e-12);
  EXPECT_NEAR(wilks_confidence(10, wilks_share(10, 0.95)), 0.95, 1e-12);
}

}  // namespace
}  // namespace tcert::study
