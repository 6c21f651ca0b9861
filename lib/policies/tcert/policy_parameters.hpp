#pragma once
/// \file
/// Parameters of the policies.

#include <cstdint>
#include <numbers>
#include <tcert/parameter_fields.hpp>

namespace tcert::policies {

/// Names, defaults, bounds and what each is for: parameters/policies.def.
struct PolicyParameters {
#define TCERT_NUMBER TCERT_MEMBER_NUMBER
#include <tcert/parameters/policies.def>
};

/// See tcert/parameter_fields.hpp; the first argument only names the list.
template <class Visit>
void visit_fields(const PolicyParameters& /*list*/, Visit&& visit) {
  using Group = PolicyParameters;
#define TCERT_NUMBER TCERT_VISIT_NUMBER
#include <tcert/parameters/policies.def>
}

/// \throws std::invalid_argument naming the parameter, its value and what it must be.
void validate(const PolicyParameters& parameters);

}  // namespace tcert::policies
