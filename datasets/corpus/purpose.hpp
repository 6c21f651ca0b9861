#pragma once
/// \file
/// One random stream per purpose, so that a draw more in one place changes nothing in another.

#include <cstdint>

namespace tcert::draws {

inline constexpr std::uint32_t kDays = 0x636f'7201;
inline constexpr std::uint32_t kOutcomes = 0x636f'7202;
inline constexpr std::uint32_t kDayEffects = 0x636f'7203;
inline constexpr std::uint32_t kCourse = 0x636f'7204;
inline constexpr std::uint32_t kTightness = 0x636f'7205;
inline constexpr std::uint32_t kWedge = 0x636f'7206;
inline constexpr std::uint32_t kDrive = 0x636f'7207;
inline constexpr std::uint32_t kPose = 0x636f'7208;
inline constexpr std::uint32_t kTactile = 0x636f'7209;
inline constexpr std::uint32_t kControl = 0x636f'720a;
inline constexpr std::uint32_t kMicroStudy = 0x636f'720b;

}  // namespace tcert::draws
