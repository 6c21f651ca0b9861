#include "datasets/driven/contact.hpp"

#include <algorithm>
#include <cmath>

namespace tcert {
namespace {

constexpr double kVelocityRounding = 1e-12;  // m/s: of a projection onto a wall
constexpr double kParallel = 1e-9;           // sine of the angle between two walls that are one

bool is_allowed(Point v, std::span<const Contact> contacts, double closing_hz) noexcept {
  return std::all_of(contacts.begin(), contacts.end(), [&](const Contact& contact) {
    return dot(contact.normal, v) >= -closing_hz * contact.gap_m - kVelocityRounding;
  });
}

/// The allowed vector nearest to `wanted` of those that are offered.
class Nearest {
 public:
  Nearest(Point wanted, std::span<const Contact> contacts, double closing_hz)
      : wanted_(wanted),
        contacts_(contacts),
        closing_hz_(closing_hz),
        least2_(dot(wanted, wanted)) {}

  void offer(Point v) noexcept {
    const Point off = v - wanted_;
    if (dot(off, off) < least2_ && is_allowed(v, contacts_, closing_hz_)) {
      nearest_ = v;
      least2_ = dot(off, off);
    }
  }

  [[nodiscard]] Point get() const noexcept { return nearest_; }

 private:
  Point wanted_;
  std::span<const Contact> contacts_;
  double closing_hz_;
  double least2_;
  Point nearest_;  // 0 is always allowed
};

}  // namespace

Point nearest_allowed(Point wanted, std::span<const Contact> contacts, double closing_hz) noexcept {
  if (is_allowed(wanted, contacts, closing_hz)) {
    return wanted;
  }
  Nearest nearest(wanted, contacts, closing_hz);
  for (const Contact& contact : contacts) {
    const double lacking = -closing_hz * contact.gap_m - dot(contact.normal, wanted);
    if (lacking > 0.0) {
      nearest.offer(wanted + lacking * contact.normal);
    }
  }
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    for (std::size_t j = i + 1; j < contacts.size(); ++j) {
      const Point& a = contacts[i].normal;
      const Point& b = contacts[j].normal;
      const double sine = cross(a, b);
      if (std::abs(sine) > kParallel) {
        const double along_a = -closing_hz * contacts[i].gap_m;
        const double along_b = -closing_hz * contacts[j].gap_m;
        nearest.offer({(along_a * b.y_m - along_b * a.y_m) / sine,
                       (along_b * a.x_m - along_a * b.x_m) / sine});
      }
    }
  }
  return nearest.get();
}

}  // namespace tcert
