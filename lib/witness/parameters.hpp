#pragma once
/// \file
/// Parameters of the witness.

#include <cstdint>
#include <tcert/parameter_fields.hpp>
#include <tcert/parameters.hpp>
#include <witness/free_space.hpp>

namespace tcert::witness {

/// Names, defaults, bounds and what each is for: parameters/witness.def.
struct WitnessParameters {
#define TCERT_NUMBER TCERT_MEMBER_NUMBER
#include <witness/parameters/witness.def>
};

/// See tcert/parameter_fields.hpp; the first argument only names the list.
template <class Visit>
void visit_fields(const WitnessParameters& /*list*/, Visit&& visit) {
  using Group = WitnessParameters;
#define TCERT_NUMBER TCERT_VISIT_NUMBER
#include <witness/parameters/witness.def>
}

/// What the parameters say of F_t; the rule for obstacles is that of the certificate.
[[nodiscard]] FreeSpaceOptions free_space_options(
    const WitnessParameters& parameters, const CertificateParameters& certificate) noexcept;

}  // namespace tcert::witness
