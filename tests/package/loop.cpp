// A control loop that is guarded by its certificate: a robot in a corridor with a gate in it.
// It drives at the speed that the guards allow, until it is in the goal.

#include <array>
#include <cmath>
#include <cstdio>
#include <tcert/flag_word.hpp>
#include <tcert/runtime.hpp>

namespace {

constexpr double kTick_s = 0.1;
constexpr double kMount_m = 0.2;  // of both rays, ahead of the centre

// The simulated world: half the free width at x.
double half_width_m(double x_m) { return x_m > 2.5 && x_m < 3.0 ? 0.30 : 0.45; }

}  // namespace

int main() {
  tcert::Robot robot;
  robot.body_width_m = 0.45;
  robot.rays = {{"left", {kMount_m, 0.1}, 1.5707963267948966, 0.7, tcert::RayKind::range, {}},
                {"right", {kMount_m, -0.1}, -1.5707963267948966, 0.7, tcert::RayKind::range, {}}};
  const tcert::Course course{tcert::Disc{{0.0, 0.0}, 0.5}, tcert::Disc{{5.0, 0.0}, 0.5}};
  const tcert::CertificateParameters parameters;
  tcert::SpeedLaw law;
  law.kind = tcert::SpeedLawKind::clip;

  tcert::ActionSetup actions;
  actions.guards = {robot, parameters, law, {}, tcert::TrackingErrorTable()};
  tcert::Runtime runtime(course, actions);  // takes all memory

  double x_m = 0.0;
  tcert::CertifiedTick now;
  for (int k = 0; k < 1000 && (now.flags & tcert::flag_goal_reached) == 0; ++k) {
    const double side_m = half_width_m(x_m + kMount_m) - 0.1;
    const bool silent = k == 40;  // the left ray misses one reading
    const std::array<tcert::RayReading, 2> readings{
        {{silent ? tcert::kMissing : side_m, 0.0}, {side_m, 0.0}}};
    tcert::Tick tick;
    tick.time_ns = k * std::int64_t{100'000'000};
    tick.pose = {{x_m, 0.0}, 0.0};
    tick.rays = readings;

    const tcert::RuntimeTick all = runtime.update(tick);
    now = all.certified;
    const tcert::GuardedTick& guarded = all.acted.guarded;
    if (k % 20 == 0) {
      std::printf("%5.1f s  x %.9f  m %.9f  V %.9f  v %.9f  %s\n",
                  1e-9 * static_cast<double>(now.time_ns),
                  x_m,
                  now.margin_m,
                  now.corridor_value_m,
                  guarded.speed_mps,
                  tcert::flag_word(now.flags));
    }
    x_m += guarded.speed_mps * kTick_s;
  }
  std::printf("certificate %.17g, issued %d\n", now.certificate_m, now.issued ? 1 : 0);
  return now.issued ? 0 : 1;
}
