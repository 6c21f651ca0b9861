#pragma once
/// \file
/// Parameters of a replay.

#include <tcert/parameter_fields.hpp>

namespace tcert::study {

/// See replay.def.
struct ReplayOptions {
#define TCERT_NUMBER TCERT_MEMBER_NUMBER
#include "analysis/study/replay/replay.def"
};

/// See <tcert/parameter_fields.hpp>; the first argument only names the list.
template <class Visit>
void visit_fields(const ReplayOptions& /*list*/, Visit&& visit) {
  using Group = ReplayOptions;
#define TCERT_NUMBER TCERT_VISIT_NUMBER
#include "analysis/study/replay/replay.def"
}

/// \throws std::invalid_argument naming the option and the range it must lie in.
void validate(const ReplayOptions& options);

}  // namespace tcert::study
