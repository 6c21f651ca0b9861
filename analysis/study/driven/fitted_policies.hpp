#pragma once
/// \file
/// What is each policy's own: the cruise that gives its published median speed, its caution, and
/// how far ahead it aims.

#include <tcert/policy.hpp>

namespace tcert::study {

/// Of one policy.
struct FittedPolicy {
  double cruise_mps = 0.0;
  double caution = 0.0;
  double lookahead_m = 0.0;
};

/// As `scripts/fit_drive` wrote it to fitted_policies.def.
[[nodiscard]] const FittedPolicy& fitted_policy(policies::PolicyKind kind) noexcept;

}  // namespace tcert::study
