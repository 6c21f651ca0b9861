#include <algorithm>
#include <cmath>
#include <tcert/felt_memory.hpp>

namespace tcert::policies {

FeltMemory::FeltMemory(const PolicySetup& setup)
    : memory_(setup.certificate),
      every_(static_cast<std::uint32_t>(
          std::max(1.0, std::round(setup.parameters.memory_period_s / setup.control_period_s)))),
      order_(setup.robot.rays.size()) {}

void FeltMemory::reset() noexcept {
  memory_.clear();
  step_ = 0;
  began_ = false;
  time_s_ = 0.0;
}

// Two contacts that reach the same cell leave other last bits in the other order. So those on the
// side that wins ties come first, from the far left or right on: an order that is mirrored too.
void FeltMemory::order_contacts(const Outlook& now) noexcept {
  contacts_ = 0;
  for (std::size_t i = 0; i < now.rays.size(); ++i) {
    if (!now.rays[i].contact || std::isnan(now.rays[i].clearance_m)) {
      continue;
    }
    const auto before = [&](std::size_t other) noexcept {
      const Point a = now.rays[i].ahead;
      const Point b = now.rays[other].ahead;
      return a.y_m != b.y_m ? now.side * a.y_m > now.side * b.y_m : a.x_m > b.x_m;
    };
    std::size_t at = contacts_++;
    for (; at > 0 && before(order_[at - 1]); --at) {
      order_[at] = order_[at - 1];
    }
    order_[at] = i;
  }
}

void FeltMemory::take(const Outlook& now, const Senses& senses) noexcept {
  if (!began_) {
    first_ns_ = senses.tick.time_ns;
    began_ = true;
  }
  time_s_ = std::max(time_s_, elapsed_s(first_ns_, senses.tick.time_ns));
  if (step_++ % every_ != 0) {
    return;
  }
  order_contacts(now);
  for (std::size_t k = 0; k < contacts_; ++k) {
    const FeltRay& ray = now.rays[order_[k]];
    memory_.add(now.body.to_odometry(ray.tip()), ray.force_n, time_s_);
  }
  if (now.bump) {
    memory_.add(*now.bump, senses.bump->force_n, time_s_);
  }
}

}  // namespace tcert::policies
