/// Margins of passes by the swept area against lists that are gone through from the start at every
/// tick: what a step is worth when it is looked at, which steps a pass has, and what is settled.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <tcert/swept_margins.hpp>
#include <vector>

namespace tcert {
namespace {

constexpr double kNeeded = 0.45 + 2.0 * 0.02;

Robot robot_of_test() {
  Robot robot;
  robot.tracking_buffer_m = 0.02;
  robot.rays = {{"left", {0.1, 0.1}, 0.5 * std::numbers::pi, 0.6, RayKind::range, {}},
                {"right", {0.1, -0.1}, -0.5 * std::numbers::pi, 0.6, RayKind::range, {}}};
  return robot;
}

/// The rule of swept_margins.hpp, with nothing kept that can be computed again.
class Slow {
 public:
  struct Step {
    Point from, to;
    double travel_m, slack_m;
    Pose pose;        // where it is said to be narrowest
    double radius_m;  // of the turn there
    double spread_m = 0.0;
    double value_m = -kNeeded;  // as of the last look
    bool settled = false;
  };
  struct Pass {
    std::size_t first = 0, last = 0;
    double handed_m = 0.0;
  };

  Slow(SweptArea& area, double lag_m) : area_(area), lag_m_(lag_m) {}

  void tick(const Pose& pose, double travel_m, double slack_m, double radius_m, bool broken) {
    const Point to = pose.position;
    const bool joins_after = !steps.empty() && last_tick_ + 1 != steps.size();
    if (!broken && !joins_after && distance(steps.back().to, to) < 0.01 * (1.0 - 1e-9)) {
      steps.back().spread_m = std::max(steps.back().spread_m, distance(steps.back().to, to));
      if (slack_m < steps.back().slack_m) {
        steps.back().slack_m = slack_m;
        steps.back().radius_m = radius_m;
      }
      steps.back().value_m = -kNeeded;
    } else {
      push({broken ? to : last_, to, travel_m, slack_m, pose, radius_m});
      last_tick_ = steps.size() - 1;
    }
    last_ = to;
    if (broken) {
      start();
    }
  }
  void push(const Step& step) {
    for (Step& old : steps) {
      if (!old.settled && step.travel_m - old.travel_m > lag_m_ * (1.0 + 1e-9)) {
        look(old);
        old.settled = true;
      }
    }
    steps.push_back(step);
  }
  void start() { current_ = last_tick_; }
  double finish() {
    passes.push_back({current_, steps.size() - 1, 0.0});
    passes.back().handed_m = narrowest(passes.back()).value_m;
    return passes.back().handed_m;
  }
  void look_at_all() {
    for (Step& step : steps) {
      if (!step.settled) {
        look(step);
      }
    }
  }
  /// The first of the steps with the least value.
  [[nodiscard]] const Step& narrowest(const Pass& pass) const {
    const auto first = steps.begin() + static_cast<std::ptrdiff_t>(pass.first);
    const auto end = steps.begin() + static_cast<std::ptrdiff_t>(pass.last) + 1;
    return *std::min_element(
        first, end, [](const Step& a, const Step& b) { return a.value_m < b.value_m; });
  }

  std::vector<Step> steps;
  std::vector<Pass> passes;

 private:
  void look(Step& step) {
    const double free_m = area_.clearance(step.from, step.to).distance_m;
    step.value_m = std::min(2.0 * (free_m - step.spread_m) - kNeeded, step.slack_m);
  }

  SweptArea& area_;
  double lag_m_;
  std::size_t last_tick_ = 0, current_ = 0;
  Point last_;
};

class Drive {
 public:
  Drive(std::uint32_t seed, double lag_m) : parameters_(of(lag_m)), engine_(seed) {}

  void run() {
    for (int k = 0; k < 700; ++k) {
      tick(k);
      if (::testing::Test::HasFatalFailure()) {
        return;
      }
    }
    EXPECT_GT(raised_, 20U) << "too few margins rise to test anything";
    EXPECT_GT(above_zero_, 5U) << "no pass is known to be wide enough";
  }

 private:
  static CertificateParameters of(double lag_m) {
    CertificateParameters parameters;
    parameters.clearance = ClearanceReading::swept;
    parameters.swept_lag_m = lag_m;
    return parameters;
  }
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }

  void tick(int k) {
    const bool broken = k == 0 || engine_() % 150 == 0;
    const double step_m = engine_() % 5 == 0 ? 0.003 : uniform(0.011, 0.03);
    pose_.yaw_rad += 0.6 * step_m * std::sin(0.01 * k);
    pose_.position = pose_.position + (broken ? 0.5 : step_m) * direction(pose_.yaw_rad);
    if (k > 0 && !broken && distance(counted_, pose_.position) >= 0.01) {
      travel_m_ += distance(counted_, pose_.position);
      counted_ = pose_.position;
    }
    const double side_m = 0.45 + 0.05 * std::sin(0.05 * k);
    const std::array<double, 2> clearances{side_m, side_m};
    if (k == 0) {
      counted_ = pose_.position;
      margins_.area().begin(pose_);
    } else if (broken) {
      counted_ = pose_.position;
      margins_.area().break_path();
    }
    margins_.area().sweep(pose_, clearances, kBearings);
    Evidence now;
    now.pose = pose_;
    now.travel_m = travel_m_;
    now.turn_slack_m = engine_() % 4 == 0 ? uniform(0.0, 0.5) : 10.0;
    now.turn_radius_m = uniform(0.5, 5.0);
    if (k == 0) {
      margins_.begin(now);
    } else if (broken) {
      margins_.break_path(now);
    } else {
      margins_.add(now);
    }
    slow_.tick(pose_, travel_m_, now.turn_slack_m, now.turn_radius_m, broken);
    if (engine_() % 30 == 0) {
      join(now);
    }
    if (k % 9 == 8) {
      const auto node = static_cast<std::uint32_t>(slow_.passes.size());
      const Certified found = margins_.finish_pass({node, Side::front}, {node + 1, Side::back});
      ASSERT_EQ(found.margin_m, slow_.finish()) << "as known so far, tick " << k;
      margins_.start_pass();
      slow_.start();
    }
    if (engine_() % 3 == 0) {
      margins_.look_at_open_steps();
      slow_.look_at_all();
    }
    hand_out(k);
  }

  void join(const Evidence& now) {
    const Point at = pose_.position + uniform(-0.1, 0.1) * Point{0.0, 1.0};
    const Node node{{at + Point{uniform(-0.1, 0.1), 0.0}, 0.0}, {1.0, 0.0}, false, false};
    margins_.add_join(at, now, node);
    slow_.push({at,
                node.pose.position,
                now.travel_m,
                now.turn_slack_m,
                {node.pose.position, pose_.yaw_rad},
                now.turn_radius_m});
  }

  /// Each pass whose margin has risen, once, with what the list says.
  void hand_out(int k) {
    std::map<std::uint32_t, Certified> handed;
    margins_.hand_out([&](EdgeEnd from, EdgeEnd to, const Certified& certified) noexcept {
      EXPECT_EQ(to.node, from.node + 1);
      EXPECT_LE(certified.margin_m, certified.width_m - kNeeded + 1e-12);
      handed[from.node] = certified;
    });
    for (std::size_t p = 0; p < slow_.passes.size(); ++p) {
      Slow::Pass& pass = slow_.passes[p];
      const Slow::Step& narrowest = slow_.narrowest(pass);
      const double margin_m = narrowest.value_m;
      const auto found = handed.find(static_cast<std::uint32_t>(p));
      ASSERT_EQ(found != handed.end(), margin_m > pass.handed_m) << "pass " << p << ", tick " << k;
      if (found != handed.end()) {
        ASSERT_EQ(found->second.margin_m, margin_m) << "pass " << p << ", tick " << k;
        ASSERT_EQ(found->second.narrowest.position, narrowest.pose.position) << p;
        ASSERT_EQ(found->second.narrowest.yaw_rad, narrowest.pose.yaw_rad) << p;
        ASSERT_EQ(found->second.turn_radius_m, narrowest.radius_m) << p;
        pass.handed_m = margin_m;
        ++raised_;
        above_zero_ += margin_m > 0.0 ? 1 : 0;
      }
    }
  }

  static constexpr std::array<double, 2> kBearings{0.5 * std::numbers::pi, -0.5 * std::numbers::pi};
  CertificateParameters parameters_;
  std::mt19937 engine_;
  SweptMargins margins_{robot_of_test(), {}, parameters_};
  Slow slow_{margins_.area(), parameters_.swept_lag_m};
  Pose pose_;
  Point counted_;
  double travel_m_ = 0.0;
  std::size_t raised_ = 0;
  std::size_t above_zero_ = 0;
};

TEST(SweptMargins, EqualAListThatIsGoneThroughAtEveryTick) {
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    Drive(seed, 1.0).run();
  }
}

TEST(SweptMargins, SettleAStepByWhatWasSweptWithinTheLag) {
  for (std::uint32_t seed = 10; seed < 16; ++seed) {
    SCOPED_TRACE(seed);
    Drive(seed, 0.25).run();
  }
}

}  // namespace
}  // namespace tcert
