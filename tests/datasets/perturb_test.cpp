#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <table/csv_write.hpp>

#include "datasets/perturb/draw_faults.hpp"
#include "datasets/perturb/perturb_stream.hpp"
#include "datasets/perturb/perturb_trial.hpp"
#include "datasets/tick_columns.hpp"
#include "support/trial_folder.hpp"

namespace tcert::perturb {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

FaultDraw draw_of(std::string_view trial,
                  double length_s,
                  StreamKind stream = StreamKind::tactile) {
  FaultDraw draw{7, trial, stream, 5 * kSecond, 5 * kSecond + std::llround(1e9 * length_s)};
  draw.rays = {0, 1, 2};
  draw.feeling = {0, 2};
  return draw;
}

FaultOptions all_kinds() {
  FaultOptions options;
  options.dropout_good_s = 20.0;
  options.bursts_per_hour = 60.0;
  options.spikes_per_hour = 120.0;
  options.freezes_per_hour = 60.0;
  options.wide_per_hour = 60.0;
  options.biases_per_hour = 60.0;
  return options;
}

std::vector<Injection> of_kind(const std::vector<Injection>& all, FaultKind kind) {
  std::vector<Injection> some;
  std::ranges::copy_if(
      all, std::back_inserter(some), [&](const Injection& one) { return one.kind == kind; });
  return some;
}

bool same(const std::vector<Injection>& a, const std::vector<Injection>& b) {
  return std::ranges::equal(a, b, [](const Injection& x, const Injection& y) {
    return x.kind == y.kind && x.ray == y.ray && x.start_ns == y.start_ns && x.end_ns == y.end_ns;
  });
}

TEST(DrawFaults, GivesEachKindOfEachStreamOfEachTrialDrawsOfItsOwn) {
  const auto all = draw_faults(all_kinds(), draw_of("t1", 3600.0));
  for (const FaultKind kind : kFaultKinds) {
    FaultOptions alone = all_kinds();
    alone.dropout_good_s = kind == FaultKind::dropout ? alone.dropout_good_s : 0.0;
    alone.bursts_per_hour = kind == FaultKind::latency ? alone.bursts_per_hour : 0.0;
    alone.spikes_per_hour = kind == FaultKind::spike ? alone.spikes_per_hour : 0.0;
    alone.freezes_per_hour = kind == FaultKind::freeze ? alone.freezes_per_hour : 0.0;
    alone.wide_per_hour = kind == FaultKind::wide ? alone.wide_per_hour : 0.0;
    alone.biases_per_hour = kind == FaultKind::bias ? alone.biases_per_hour : 0.0;
    const auto one = draw_faults(alone, draw_of("t1", 3600.0));
    EXPECT_FALSE(one.empty());
    EXPECT_TRUE(same(one, of_kind(all, kind))) << to_string(kind);
    EXPECT_FALSE(same(one, draw_faults(alone, draw_of("t2", 3600.0)))) << to_string(kind);
    FaultDraw seed = draw_of("t1", 3600.0);
    seed.seed = 8;
    EXPECT_FALSE(same(one, draw_faults(alone, seed))) << to_string(kind);
    EXPECT_FALSE(same(one, draw_faults(alone, draw_of("t1", 3600.0, StreamKind::pose))));
  }
  EXPECT_TRUE(draw_faults({}, draw_of("t1", 3600.0)).empty());
}

TEST(DrawFaults, KeepsToTheTrialAndEndsEveryFaultInIt) {
  for (const double length : {0.0, 0.05, 1.0, 40.0, 3600.0}) {
    const FaultDraw draw = draw_of("t" + std::to_string(length), length);
    std::int64_t before = draw.begin_ns;
    for (const Injection& one : draw_faults(all_kinds(), draw)) {
      EXPECT_GE(one.start_ns, before);
      EXPECT_LE(one.start_ns, one.end_ns);
      EXPECT_LE(one.end_ns, draw.end_ns);
      before = one.start_ns;
      EXPECT_EQ(one.ray.has_value(),
                one.kind != FaultKind::dropout && one.kind != FaultKind::latency);
      EXPECT_TRUE(one.kind != FaultKind::spike || *one.ray != 1) << "has no force";
    }
  }
}

// Share of time lost b / (g + b), losses per hour 3600 / (g + b), mean length b: within four
// standard errors, which are those of 400 trials.
TEST(DrawFaults, LosesAsMuchAsTheGilbertElliottFormulaSays) {
  FaultOptions options;
  for (const auto& [good, bad] : {std::pair(8.0, 2.0), std::pair(30.0, 0.3), std::pair(1.0, 4.0)}) {
    options.dropout_good_s = good;
    options.dropout_bad_s = bad;
    double sum = 0.0;
    double squares = 0.0;
    double whole = 0.0;
    std::size_t complete = 0;
    constexpr int kTrials = 400;
    constexpr double kLengthS = 300.0;
    for (int trial = 0; trial < kTrials; ++trial) {
      const FaultDraw draw = draw_of("trial" + std::to_string(trial), kLengthS);
      double lost = 0.0;
      for (const Injection& one : draw_faults(options, draw)) {
        const double length = 1e-9 * static_cast<double>(one.end_ns - one.start_ns);
        lost += length / kLengthS;
        if (one.start_ns > draw.begin_ns && one.start_ns < draw.begin_ns + 200 * kSecond) {
          whole += length;
          ++complete;
        }
      }
      sum += lost;
      squares += lost * lost;
    }
    const double mean = sum / kTrials;
    const double error = std::sqrt((squares / kTrials - mean * mean) / kTrials);
    EXPECT_NEAR(mean, bad / (good + bad), 4.0 * error);
    EXPECT_LT(error, 0.02);
    const auto n = static_cast<double>(complete);
    EXPECT_NEAR(whole / n, bad, 4.0 * bad / std::sqrt(n))
        << "exponential: mean and deviation agree";
    // Whole cycles in the 200 s: one that begins is preceded by a good time.
    EXPECT_NEAR(n / kTrials, 200.0 / (good + bad), 4.0 * std::sqrt(200.0 / (good + bad) / kTrials));
  }
}

TEST(DrawFaults, BeginsAtTheRateThatWasAskedFor) {
  FaultOptions options;
  options.spikes_per_hour = 90.0;
  std::size_t spikes = 0;
  std::size_t on_ray_0 = 0;
  for (int trial = 0; trial < 200; ++trial) {
    for (const Injection& one : draw_faults(options, draw_of("s" + std::to_string(trial), 720.2))) {
      ++spikes;
      on_ray_0 += one.ray == 0U ? 1 : 0;
    }
  }
  EXPECT_NEAR(static_cast<double>(spikes), 3600.0, 4.0 * 60.0);
  EXPECT_NEAR(static_cast<double>(on_ray_0), 1800.0, 4.0 * 30.0);
}

/// A robot with a bend ray "a", 0.6 m at bend 0 down to 0 m at 1.2 rad, and a range ray "b".
class PerturbStream : public test_support::TrialFolder {
 protected:
  PerturbStream() {
    bundle_.info.robot.rays = {{"a", {}, 1.5, 0.6, RayKind::bend, {{0.0, 1.2}, {0.6, 0.0}}},
                               {"b", {}, -1.5, 2.0, RayKind::range, {}}};
    bundle_.info.range_keys = {{}, {{0.0}, 0.05, 1.9}};
  }

  /// Rows at 0, 0.1, ..., 2 s: a bends by the time, b reads 1 m and a tenth of the time.
  static std::string tactile() {
    std::string text = "# synthetic, seed 3\nnote,time_s,a_bend_rad,a_fsr_n,b_range_m\n";
    for (int i = 0; i <= 20; ++i) {
      const std::string time = table::number_text(0.1 * i);
      text += "\"x, y\"," + std::to_string(i / 10) + "." + std::to_string(i % 10) + "00," + time +
              ",2.50," + table::number_text(1.0 + 0.01 * i) + "\n";
    }
    return text;
  }

  /// The rows of the perturbed text, header first, comments left out.
  std::vector<std::string> perturbed(const std::string& text, std::vector<Injection> faults) {
    const table::Bytes bytes = table::Bytes::copy_of(text);
    const table::NumberOptions columns = tactile_columns(bundle_.info.robot);
    table::CsvOptions csv;
    csv.fold_names = true;
    faults_ = std::move(faults);
    whole_ =
        perturb_stream({bytes, csv, columns, 0, 2 * kSecond, false}, bundle_.info, 0.9, faults_)
            .text;
    std::vector<std::string> rows;
    std::size_t begin = 0;
    for (std::size_t end = 0; (end = whole_.find('\n', begin)) != std::string::npos;
         begin = end + 1) {
      if (whole_[begin] != '#') {
        rows.push_back(whole_.substr(begin, end - begin));
      }
    }
    return rows;
  }

  static std::vector<std::string> cells_of(const std::string& row) {
    std::vector<std::string> cells;
    const std::string line = row + "\n";
    table::CsvCursor cursor{line.data(), line.data() + line.size()};
    static_cast<void>(table::scan_record(cursor, ',', cells));
    return cells;
  }

  static Injection fault(FaultKind kind,
                         std::optional<std::size_t> ray,
                         std::int64_t start_ms,
                         std::int64_t end_ms,
                         double size = 0.0) {
    return {kind, ray, start_ms * 1'000'000, end_ms * 1'000'000, size};
  }

  std::vector<Injection> faults_;
  std::string whole_;
};

TEST_F(PerturbStream, AddsHalfASineOfForceThatReleases) {
  const auto before = perturbed(tactile(), {});
  EXPECT_EQ(whole_, tactile()) << "without a fault it is what it was";
  const auto rows = perturbed(tactile(), {fault(FaultKind::spike, 0, 450, 1050, 8.0)});
  ASSERT_EQ(rows.size(), before.size());
  double most = 0.0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double time = 0.1 * (static_cast<double>(i) - 1.0);
    if (time < 0.45 || time >= 1.05) {
      EXPECT_EQ(rows[i], before[i]) << "the same bytes";
      continue;
    }
    const auto cells = cells_of(rows[i]);
    const auto old = cells_of(before[i]);
    const double force = std::stod(cells[3]);
    EXPECT_NEAR(force, 2.5 + 8.0 * std::sin(std::numbers::pi * (time - 0.45) / 0.6), 1e-9);
    most = std::max(most, force);
    for (const std::size_t other : {0U, 1U, 2U, 4U}) {
      EXPECT_EQ(cells[other], old[other]);
    }
  }
  EXPECT_GT(most, 10.0);
  EXPECT_EQ(faults_[0].samples, 6U);
  EXPECT_EQ(whole_.substr(0, 20), tactile().substr(0, 20)) << "the comment stays";
}

TEST_F(PerturbStream, HoldsWhatAFrozenRaySaidLastAndEnds) {
  const auto before = perturbed(tactile(), {});
  const auto rows = perturbed(tactile(), {fault(FaultKind::freeze, 0, 500, 900)});
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const bool frozen = i >= 6 && i < 10;
    const auto cells = cells_of(rows[i]);
    EXPECT_EQ(cells[2], cells_of(before[frozen ? 5 : i])[2]) << i;
    EXPECT_EQ(cells[4], cells_of(before[i])[4]) << "the other ray";
    EXPECT_EQ(cells[1], cells_of(before[i])[1]) << "the time, as it was written";
  }
  EXPECT_EQ(faults_[0].samples, 4U);
  EXPECT_DOUBLE_EQ(faults_[0].size, 0.4);
}

TEST_F(PerturbStream, SticksAtAWideReadingWithoutForce) {
  auto rows = perturbed(
      tactile(), {fault(FaultKind::wide, 0, 500, 900), fault(FaultKind::wide, 1, 1500, 1700)});
  for (std::size_t i = 6; i < 10; ++i) {
    const auto cells = cells_of(rows[i]);
    EXPECT_DOUBLE_EQ(
        calibrated_clearance(bundle_.info.robot.rays[0].calibration, std::stod(cells[2])), 0.54);
    EXPECT_EQ(cells[3], "0");
  }
  EXPECT_EQ(cells_of(rows[16])[4], "1.8");
  EXPECT_EQ(cells_of(rows[18])[4], "1.17");
  EXPECT_EQ(unit_of(faults_[0], bundle_.info.robot.rays), "rad");
  EXPECT_EQ(unit_of(faults_[1], bundle_.info.robot.rays), "m");
}

TEST_F(PerturbStream, BiasesClearanceThroughTheCalibrationAndWithinTheReach) {
  const auto before = perturbed(tactile(), {});
  const auto rows = perturbed(
      tactile(),
      {fault(FaultKind::bias, 0, 0, 2000, 0.1), fault(FaultKind::bias, 1, 0, 2000, -0.97)});
  for (std::size_t i = 1; i < 21; ++i) {
    const auto cells = cells_of(rows[i]);
    const double bend = std::stod(cells_of(before[i])[2]);
    EXPECT_NEAR(std::stod(cells[2]), std::max(std::min(bend, 1.2) - 0.2, 0.0), 1e-12);
    const double range = std::stod(cells_of(before[i])[4]);
    EXPECT_NEAR(std::stod(cells[4]), std::max(range - 0.97, 0.05), 1e-12);
  }
  EXPECT_EQ(faults_[0].samples, 19U) << "a bend of 0 states the longest clearance already";
  EXPECT_EQ(rows[21], before[21]) << "the end is not in it";
}

TEST_F(PerturbStream, StatesWhenLateSamplesArriveAndLosesThoseInBetween) {
  const auto before = perturbed(tactile(), {});
  const auto rows = perturbed(tactile(),
                              {fault(FaultKind::dropout, {}, 0, 250),
                               fault(FaultKind::latency, {}, 500, 800, 0.3),
                               fault(FaultKind::dropout, {}, 1900, 2000)});
  EXPECT_EQ(rows[0], before[0] + ",arrival_s");
  ASSERT_EQ(rows.size(), before.size() - 3) << "the first sample is never lost";
  EXPECT_EQ(rows[1], before[1] + ",0");
  EXPECT_EQ(cells_of(rows[2])[1], "0.300");
  for (std::size_t i = 2; i + 1 < rows.size(); ++i) {
    const double time = std::stod(cells_of(rows[i])[1]);
    const double arrival = std::stod(cells_of(rows[i])[5]);
    EXPECT_DOUBLE_EQ(arrival, time > 0.45 && time < 0.75 ? 0.8 : time);
  }
  EXPECT_EQ(faults_[0].size, 2.0);
  EXPECT_EQ(faults_[1].samples, 3U);
  EXPECT_EQ(faults_[2].samples, 1U);
  // Once more: those that are late already are no earlier.
  const auto again = perturbed(whole_, {fault(FaultKind::latency, {}, 600, 700, 0.1)});
  EXPECT_EQ(again.size(), rows.size());
  EXPECT_EQ(again, rows);
}

TEST_F(PerturbStream, KeepsOtherDialectsAndCellsWithoutAValue) {
  const std::string text =
      "time_s;a_bend_rad;b_range_m\r\n0;0.5;NA\r\n0.1;NA;inf\r\n0.2;0.7;0\r\n0.3;0.8;1\r\n";
  const auto rows = perturbed(
      text, {fault(FaultKind::freeze, 0, 100, 300), fault(FaultKind::bias, 1, 0, 2000, 0.5)});
  EXPECT_EQ(rows,
            (std::vector<std::string>{"time_s;a_bend_rad;b_range_m\r",
                                      "0;0.5;NA\r",
                                      "0.1;NA;inf\r",
                                      "0.2;0.5;0\r",
                                      "0.3;0.8;1.5\r"}));
}

// What it writes is read again, and the ticks of a burst are late as resample() says.
TEST_F(PerturbStream, WritesLogsThatAreRead) {
  std::string pose = "time_s,x_m,y_m,yaw_rad\n";
  for (int i = 0; i <= 1200; ++i) {
    pose += table::number_text(0.05 * i) + "," + table::number_text(0.01 * i) + ",0,0\n";
  }
  std::string touch = "time_s,a_bend_rad,a_fsr_n,b_range_m\n";
  for (int i = 0; i <= 1200; ++i) {
    touch += table::number_text(0.05 * i) + ",0.3,1,1\n";
  }
  write("pose.csv", pose);
  write("tactile.csv", touch);
  PerturbPlan plan{all_kinds(), {StreamKind::tactile}, 1};
  plan.faults.bursts_per_hour = 600.0;
  plan.faults.spikes_per_hour = 600.0;
  const PerturbedTrial made = perturb_trial(bundle_, trial_, plan);
  ASSERT_FALSE(made.rejected);
  ASSERT_EQ(made.files.size(), 1U) << "nothing happens to the pose";
  EXPECT_EQ(made.files[0].name, "logs/t/tactile.csv");
  std::size_t lost = 0;
  for (const Injection& one : made.streams.at(1).injections) {
    EXPECT_GT(one.samples, 0U);
    lost += one.kind == FaultKind::dropout ? one.samples : 0;
  }
  const std::size_t whole_ticks = (read(), resample(*log_)).size();
  write("tactile.csv", made.files[0].text);
  static_cast<void>(read());
  ASSERT_TRUE(log_.has_value());
  EXPECT_EQ(log_->tactile.time_ns.size() + lost, 1201U);
  const TickTable ticks = resample(*log_);
  EXPECT_EQ(ticks.size(), whole_ticks) << "ticks stay where they are";
  EXPECT_GT(std::ranges::count(ticks.stale, 1), 5);
  // The same again, whatever else there is.
  write("tactile.csv", touch);
  EXPECT_EQ(perturb_trial(bundle_, trial_, plan).files[0].text, made.files[0].text);
}

TEST_F(PerturbStream, EmptiesLostTicksOfALogThatIsMerged) {
  std::string text = "time_s,x_m,y_m,yaw_rad,a_bend_rad,a_fsr_n,b_range_m\n";
  for (int i = 0; i <= 600; ++i) {
    text += table::number_text(0.1 * i) + ",0,0,0,0.3,1,1\n";
  }
  write("ticks.csv", text);
  PerturbPlan plan{{}, {StreamKind::tactile}, 1};
  plan.faults.dropout_good_s = 5.0;
  const PerturbedTrial made = perturb_trial(bundle_, trial_, plan);
  ASSERT_EQ(made.files.size(), 1U);
  write("ticks.csv", made.files[0].text);
  EXPECT_EQ(read(), std::vector<std::string>{});
  const TickTable ticks = resample(*log_);
  ASSERT_EQ(ticks.size(), 601U);
  std::size_t lost = 0;
  for (const Injection& one : made.streams[0].injections) {
    lost += one.samples;
  }
  EXPECT_GT(lost, 20U);
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(ticks.stale, 1)), lost);
  plan.faults.bursts_per_hour = 1.0;
  EXPECT_TRUE(perturb_trial(bundle_, trial_, plan).rejected) << "ticks have no arrivals";
}

}  // namespace
}  // namespace tcert::perturb
