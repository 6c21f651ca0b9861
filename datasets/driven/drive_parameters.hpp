#pragma once
/// \file
/// The parameters of driven trials.

#include <cstdint>
#include <numbers>
#include <tcert/parameter_fields.hpp>

namespace tcert {

enum class WorldChoice : std::uint8_t { any, passable };

/// Names, defaults, bounds and what each is for: drive.def.
struct DriveParameters {
#define TCERT_WORD TCERT_MEMBER_WORD
#define TCERT_NUMBER TCERT_MEMBER_NUMBER
#include "datasets/driven/drive.def"
};

/// See <tcert/parameter_fields.hpp>; the first argument only names the list.
template <class Visit>
void visit_fields(const DriveParameters& /*list*/, Visit&& visit) {
  using Group = DriveParameters;
#define TCERT_WORD TCERT_VISIT_WORD
#define TCERT_NUMBER TCERT_VISIT_NUMBER
#include "datasets/driven/drive.def"
}

/// \throws std::invalid_argument naming the parameter and what it must be.
void validate(const DriveParameters& parameters);

}  // namespace tcert
