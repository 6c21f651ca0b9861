#pragma once
/// \file
/// A robot, a course, ticks and what is known of them, in the words of the C interface and back.

#include <tcert/tcert.h>
#include <array>
#include <deque>
#include <tcert/certifier.hpp>
#include <tcert/guards.hpp>
#include <tcert/robot.hpp>
#include <tcert/tick.hpp>
#include <vector>

namespace tcert::test_support {

/// What tcert_create takes; keeps what its structs point to. `robot` must outlive it.
class CSetup {
 public:
  CSetup(const Robot& robot, const Course& course);
  CSetup(const CSetup&) = delete;
  CSetup& operator=(const CSetup&) = delete;

  /// tcert_create with these; what is wrong is in `message`.
  [[nodiscard]] tcert_status create(tcert_certifier*& certifier);

  std::vector<tcert_ray> rays;
  tcert_robot robot{};
  tcert_course course{};
  tcert_parameters parameters{};
  std::array<char, 200> message{};

 private:
  [[nodiscard]] tcert_region to_c(const Region& region);

  std::deque<std::vector<tcert_point>> polygons_;
};

/// A tick whose readings lie in `readings`.
[[nodiscard]] tcert_tick to_c(const Tick& tick, std::vector<tcert_reading>& readings);

/// All zero but its size.
[[nodiscard]] tcert_output empty_output() noexcept;

[[nodiscard]] CertifiedTick certified(const tcert_output& output) noexcept;
[[nodiscard]] GuardedTick guarded(const tcert_output& output) noexcept;

}  // namespace tcert::test_support
