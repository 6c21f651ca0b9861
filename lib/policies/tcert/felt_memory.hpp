#pragma once
/// \file
/// The contact memory of a policy: the core's, fed with what a policy feels.

#include <cstdint>
#include <tcert/contact_memory.hpp>
#include <tcert/pilot.hpp>
#include <vector>

namespace tcert::policies {

/// Takes the contacts of every so manieth step, for the memory's gain is meant for the ticks of
/// 10 Hz. The constructor takes all memory; every other member is noexcept.
class FeltMemory {
 public:
  explicit FeltMemory(const PolicySetup& setup);

  void reset() noexcept;

  /// Tips of rays in contact, and where the body touches. \pre `now` is whole.
  void take(const Outlook& now, const Senses& senses) noexcept;

  /// Mean memory along a straight line; see ContactMemory::mean_along.
  [[nodiscard]] double mean_along(Point from, Point direction, double length_m) const noexcept {
    return memory_.mean_along(from, direction, length_m, time_s_);
  }
  /// Largest memory within a radius.
  [[nodiscard]] double largest_within(Point centre, double radius_m) const noexcept {
    return memory_.largest_within(centre, radius_m, time_s_);
  }

 private:
  void order_contacts(const Outlook& now) noexcept;

  ContactMemory memory_;
  std::uint32_t every_;  // steps
  std::uint32_t step_ = 0;
  std::int64_t first_ns_ = 0;
  bool began_ = false;
  double time_s_ = 0.0;
  std::vector<std::size_t> order_;  // of rays in contact
  std::size_t contacts_ = 0;
};

}  // namespace tcert::policies
