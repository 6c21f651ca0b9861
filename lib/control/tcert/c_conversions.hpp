#pragma once
/// \file
/// From the structs of the C interface to those of the library, and back. Internal to c_api.cpp.

#include <tcert/tcert.h>
#include <cstddef>
#include <stdexcept>
#include <tcert/certifier.hpp>
#include <tcert/runtime.hpp>
#include <tcert/struct_size.hpp>

namespace tcert {

// The last members of ABI version 1. What comes later is appended behind them.
#define TCERT_FIRST_SIZE(type, last) \
  template <>                        \
  inline constexpr std::size_t kFirstSize<type> = (offsetof(type, last) + sizeof(type::last))
TCERT_FIRST_SIZE(tcert_robot, curvature_buffer_per_m);
TCERT_FIRST_SIZE(tcert_course, goal);
TCERT_FIRST_SIZE(tcert_parameters, tracking_radius_m);
TCERT_FIRST_SIZE(tcert_tick, segment_start);
TCERT_FIRST_SIZE(tcert_output, triggers_began);
TCERT_FIRST_SIZE(tcert_bottleneck, turn_radius_m);

namespace c_interface {

/// A struct_size that no version of the header has.
class WrongSize : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

[[nodiscard]] tcert_parameters default_parameters() noexcept;

/// These throw WrongSize, or std::invalid_argument that names the member which is out of range.
[[nodiscard]] tcert_parameters whole_parameters(const tcert_parameters& given);
[[nodiscard]] Robot to_robot(const tcert_robot& given);
[[nodiscard]] Course to_course(const tcert_course& given);

/// From whole parameters. \throws std::invalid_argument for a word that is not known.
[[nodiscard]] CertificateParameters to_certificate_parameters(const tcert_parameters& whole);
[[nodiscard]] ActionSetup to_actions(const tcert_parameters& whole, const Robot& robot);

[[nodiscard]] tcert_output to_output(const RuntimeTick& tick) noexcept;

}  // namespace c_interface
}  // namespace tcert
