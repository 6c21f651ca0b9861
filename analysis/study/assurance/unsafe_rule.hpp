#pragma once
/// \file
/// Parameters of what counts as unsafe.

#include <tcert/parameter_fields.hpp>

namespace tcert::study {

/// See unsafe.def.
struct UnsafeRule {
#define TCERT_NUMBER TCERT_MEMBER_NUMBER
#include "analysis/study/assurance/unsafe.def"
};

/// See <tcert/parameter_fields.hpp>; the first argument only names the list.
template <class Visit>
void visit_fields(const UnsafeRule& /*list*/, Visit&& visit) {
  using Group = UnsafeRule;
#define TCERT_NUMBER TCERT_VISIT_NUMBER
#include "analysis/study/assurance/unsafe.def"
}

}  // namespace tcert::study
