// Any robot, course, parameters and ticks: what is out of bounds is refused by the constructors
// with invalid_argument, and what is accepted keeps the contract of a control loop: no undefined
// behaviour, T_t never falls while unknown space is occupied, neither T_t nor V_t is NaN, the speed
// lies between halt and v_max, and a refused tick changes nothing.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <stdexcept>
#include <tcert/certifier.hpp>
#include <tcert/guards.hpp>
#include <type_traits>
#include <vector>

#include "fuzz/check.hpp"

namespace tcert {
namespace {

using fuzz::require;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();

/// Draws from the bytes of an input; zeros once they are used up.
class Draws {
 public:
  Draws(const std::uint8_t* data, std::size_t size) : next_(data), left_(size) {}

  [[nodiscard]] bool empty() const noexcept { return left_ == 0; }
  std::uint8_t byte() noexcept {
    if (left_ == 0) {
      return 0;
    }
    --left_;
    return *next_++;
  }
  std::uint64_t bits() noexcept {
    std::uint64_t value = 0;
    for (int i = 0; i < 8; ++i) {
      value = value << 8U | byte();
    }
    return value;
  }
  std::uint32_t below(std::uint32_t n) noexcept { return byte() % n; }

  /// Near `usual` most of the time, else anything that a double can be.
  double number(double usual) noexcept {
    const std::array<double, 14> odd = {0.0,
                                        -0.0,
                                        -usual,
                                        1e300,
                                        5e-324,
                                        std::nan(""),
                                        kInfinity,
                                        -kInfinity,
                                        1e9,
                                        -1e9,
                                        usual * 1e3,
                                        usual * 1e-3,
                                        kLargest,
                                        -kLargest};
    const std::uint8_t which = byte();
    if (which < odd.size()) {
      return odd[which];
    }
    if (which < 20) {
      const std::uint64_t any = bits();
      double value = 0.0;
      std::memcpy(&value, &any, sizeof value);
      return value;
    }
    return usual * (0.25 + byte() / 128.0);
  }

 private:
  const std::uint8_t* next_;
  std::size_t left_;
};

/// A few of the fields drawn anew: numbers, words within their words, and room for little, so that
/// it is used up.
template <class Group>
Group drawn(Draws& draws) {
  std::uint64_t changed = 0;  // a bit for each field
  for (std::uint32_t changes = draws.below(5); changes > 0; --changes) {
    changed |= std::uint64_t{1} << draws.below(64);
  }
  Group group;
  visit_fields(group, [&](const auto& field, auto member) {
    auto& value = group.*member;
    using Value = std::decay_t<decltype(value)>;
    const bool anew = (changed & 1U) != 0;
    changed >>= 1U;
    if constexpr (std::is_same_v<Value, double>) {
      if (anew) {
        value = draws.number(value == 0.0 ? 0.1 : value);
      }
    } else if constexpr (std::is_enum_v<Value>) {
      if (anew) {
        const auto spaces = std::count(field.words.begin(), field.words.end(), ' ');
        value = static_cast<Value>(draws.below(static_cast<std::uint32_t>(spaces) + 1));
      }
    } else {
      value = anew ? 2 + 4 * draws.byte() : 64;
    }
  });
  return group;
}

template <class Group>
bool within_bounds(const Group& group) {
  bool within = true;
  visit_fields(group, [&](const auto& field, auto member) {
    using Value = std::decay_t<decltype(group.*member)>;
    if constexpr (!std::is_enum_v<Value>) {
      within = within && field.bounds.contain(static_cast<double>(group.*member));
    }
  });
  return within;
}

Robot drawn_robot(Draws& draws) {
  auto robot = drawn<Robot>(draws);
  const std::uint32_t rays = draws.below(5);
  for (std::uint32_t k = 0; k < rays; ++k) {
    const double side = k % 2 == 0 ? 1.0 : -1.0;
    const bool bends = draws.below(2) == 0;
    Ray ray{"r",
            {draws.number(0.2), side * draws.number(0.1)},
            side * draws.number(1.57),
            draws.number(1.0),
            bends ? RayKind::bend : RayKind::range,
            {}};
    if (bends) {
      ray.calibration = {{0.0, draws.number(0.5), 1.2}, {0.6, draws.number(0.4), 0.0}};
    }
    robot.rays.push_back(ray);
  }
  return robot;
}

std::optional<Region> drawn_region(Draws& draws, double ahead_m) {
  switch (draws.below(3)) {
    case 0:
      return std::nullopt;
    case 1:
      return Disc{{draws.number(ahead_m), 0.0}, draws.number(0.5)};
    default:
      return Polygon{{{ahead_m, -1.0}, {draws.number(ahead_m + 1.0), -1.0}, {ahead_m, 1.0}}};
  }
}

/// A robot that wanders in small steps, and now and then something else.
class Wanderer {
 public:
  Wanderer(Draws& draws, std::size_t rays) : draws_(draws), readings_(rays) {
    time_ns_ = draws.below(4) == 0 ? static_cast<std::int64_t>(draws.bits()) : 0;
  }

  Tick next() {
    const std::uint8_t what = draws_.byte();
    pose_.yaw_rad += (what % 16 - 8) * 0.02;
    pose_.position = pose_.position + 0.05 * direction(pose_.yaw_rad);
    time_ns_ += time_ns_ < std::numeric_limits<std::int64_t>::max() - 100'000'000 ? 100'000'000 : 0;
    for (RayReading& reading : readings_) {
      reading = {0.3 + (what >> 4U) * 0.02, what % 5 == 0 ? 3.0 : 0.0};
    }
    Tick tick{time_ns_, pose_, readings_, what % 32 == 8, what % 32 == 9};
    switch (what % 32) {
      case 1:
        tick.pose.position.x_m = draws_.number(1.0);
        break;
      case 2:
        tick.pose.yaw_rad = draws_.number(1.0);
        break;
      case 3:
        pose_ = {{draws_.number(2.0), draws_.number(2.0)}, draws_.number(3.0)};
        tick.pose = pose_;
        if (!(std::abs(pose_.position.x_m) < 1e9 && std::abs(pose_.position.y_m) < 1e9 &&
              std::abs(pose_.yaw_rad) < 1e9)) {
          pose_ = {};
        }
        break;
      case 4:
        tick.time_ns = static_cast<std::int64_t>(draws_.bits());
        time_ns_ = std::max(time_ns_, tick.time_ns);
        break;
      case 5:
        if (!readings_.empty()) {
          readings_.front() = {draws_.number(0.5), draws_.number(1.0)};
        }
        break;
      case 6:
        tick.rays = tick.rays.first(tick.rays.size() / 2);
        break;
      default:
        break;
    }
    return tick;
  }

 private:
  Draws& draws_;
  std::vector<RayReading> readings_;
  Pose pose_;
  std::int64_t time_ns_ = 0;
};

void drive(Draws& draws) {
  const Robot robot = drawn_robot(draws);
  const Course course{drawn_region(draws, 0.0), drawn_region(draws, 2.0)};
  const auto parameters = drawn<CertificateParameters>(draws);
  const auto law = drawn<SpeedLaw>(draws);
  const auto guard_parameters = drawn<GuardParameters>(draws);
  Certifier certifier(robot, course, parameters);
  Guards guards({robot, parameters, law, guard_parameters, TrackingErrorTable()});
  require(within_bounds(robot) && within_bounds(parameters) && within_bounds(law) &&
              within_bounds(guard_parameters),
          "what is out of bounds is refused");
  Wanderer wanderer(draws, robot.rays.size());
  CertifiedTick before;
  double best_m = -kInfinity;
  for (int i = 0; i < 400 && !draws.empty(); ++i) {
    if (draws.below(200) == 199) {
      certifier.reset();
      guards.reset();
      best_m = -kInfinity;
      before = {};
    }
    const Tick tick = wanderer.next();
    const CertifiedTick now = certifier.update(tick);
    const GuardedTick guarded = guards.update(tick, now);
    require(!std::isnan(now.certificate_m) && !std::isnan(now.corridor_value_m),
            "T and V are numbers");
    require(parameters.unknown == UnknownSpace::free || now.certificate_m >= best_m,
            "T never falls");
    best_m = std::max(best_m, now.certificate_m);
    require(guarded.speed_mps >= 0.0 && guarded.speed_mps <= law.max_speed_mps,
            "a speed of the law");
    if (i > 0 && (now.flags & (flag_bad_input | flag_stale)) != 0 && before.nodes > 0) {
      require(now.certificate_m == before.certificate_m && now.nodes == before.nodes &&
                  now.edges == before.edges && now.travel_m == before.travel_m &&
                  now.corridor_value_m == before.corridor_value_m,
              "a refused tick changes nothing");
    }
    before = now;
  }
  static_cast<void>(certifier.bottleneck());
}

}  // namespace
}  // namespace tcert

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tcert::Draws draws(data, size);
  try {
    tcert::drive(draws);
  } catch (const std::invalid_argument&) {
    return 0;
  }
  return 0;
}
