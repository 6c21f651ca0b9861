#pragma once
/// \file
/// One random stream per purpose of a driven trial; see datasets/corpus/purpose.hpp.

#include <cstdint>

namespace tcert::draws {

inline constexpr std::uint32_t kGatedCourse = 0x6472'7601;
inline constexpr std::uint32_t kGatedMargins = 0x6472'7602;
inline constexpr std::uint32_t kDrivenTactile = 0x6472'7603;
inline constexpr std::uint32_t kDrivenPose = 0x6472'7604;
inline constexpr std::uint32_t kDrivenLatency = 0x6472'7605;
inline constexpr std::uint32_t kDrivenBumper = 0x6472'7606;
inline constexpr std::uint32_t kDrivenSpeed = 0x6472'7607;
inline constexpr std::uint32_t kDrivenCamera = 0x6472'7608;
inline constexpr std::uint32_t kDrivenCrash = 0x6472'7609;
inline constexpr std::uint32_t kGatedRelief = 0x6472'760a;
inline constexpr std::uint32_t kDrivenFooting = 0x6472'760b;

}  // namespace tcert::draws
