#pragma once
/// \file
/// What the tests of a hypothesis met, each said once: whose it is stands before its detail.

#include <statistics/basics/condition.hpp>

#include "analysis/study/h1/hypothesis_h1.hpp"
#include "analysis/study/h2/hypothesis_h2.hpp"
#include "analysis/study/h3/hypothesis_h3.hpp"

namespace tcert {

/// "landmark panel, contacts: ...": what several rows of a panel have is one condition.
[[nodiscard]] statistics::Conditions conditions_of(const study::H1Table& h1);

/// Likewise of groups. One group or model without an estimate leaves those of the others: its error
/// is a warning here.
[[nodiscard]] statistics::Conditions conditions_of(const study::H2Table& h2);

/// "all: ...": by lighting.
[[nodiscard]] statistics::Conditions conditions_of(const study::H3Table& h3);

}  // namespace tcert
