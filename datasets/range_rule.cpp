#include "datasets/range_rule.hpp"

#include <algorithm>
#include <cmath>

namespace tcert {
namespace {

constexpr double kSinglePrecision = 1e-6;  // of a value: more than a float's rounding

void count_undeclared(double value, RangeCount& count) noexcept {
  ++count.undeclared;
  count.zero += value == 0.0 ? 1 : 0;
  if (value > count.highest) {
    count.below_highest = count.highest;
    count.highest = value;
    count.at_highest = 1;
  } else if (value == count.highest) {
    ++count.at_highest;
  } else {
    count.below_highest = std::max(count.below_highest, value);
  }
}

}  // namespace

bool is_no_return(std::span<const double> declared, double value) noexcept {
  return std::ranges::any_of(declared, [value](double one) {
    return std::abs(value - one) <= kSinglePrecision * std::abs(one);
  });
}

RangeRules::RangeRules(const Robot& robot, std::span<const RangeKeys> keys) {
  for (std::size_t k = 0; k < robot.rays.size(); ++k) {
    const Ray& ray = robot.rays[k];
    rays_.push_back(
        {ray.kind == RayKind::range, ray.reach_m, k < keys.size() ? keys[k] : RangeKeys{}});
  }
}

double RangeRules::resolve(std::size_t ray, double value) const noexcept {
  RangeCount forgotten;
  return resolve(ray, value, forgotten);
}

double RangeRules::resolve(std::size_t ray, double value, RangeCount& count) const noexcept {
  const RayRule& rule = rays_[ray];
  if (!rule.is_range || std::isnan(value)) {
    return value;
  }
  ++count.stated;
  if (std::isinf(value)) {
    return value > 0.0 ? rule.reach_m : 0.0;
  }
  if (is_no_return(rule.keys.no_return, value)) {
    return rule.reach_m;
  }
  if (value < 0.0) {
    ++count.negative;
    count.lowest = std::min(count.lowest, value);
    return kMissing;
  }
  if (value < rule.keys.range_min_m) {
    ++count.below_min;
    return kMissing;
  }
  if (value > rule.keys.range_max_m) {
    ++count.above_max;
    return kMissing;
  }
  count_undeclared(value, count);
  return value;
}

double RangeRules::stated(std::size_t ray, double reading) const noexcept {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (std::isnan(reading) || resolve(ray, reading) == reading) {
    return reading;
  }
  if (reading == 0.0) {
    return -kInfinity;
  }
  if (reading == rays_[ray].reach_m) {
    return kInfinity;
  }
  return reading;
}

}  // namespace tcert
