#pragma once
/// \file
/// Sets of terms: what + - * : / ^ of a formula do with them. Internal to formula.cpp.

#include <statistics/model/formula.hpp>
#include <vector>

namespace tcert::statistics {

/// Each once, in order of appearance.
using Terms = std::vector<Term>;

[[nodiscard]] bool holds(const Term& term, const Expression& variable);
void remove_terms(Terms& terms, const Terms& unwanted);

/// The variables of both.
[[nodiscard]] Term joined(const Term& a, const Term& b);
[[nodiscard]] Terms united(Terms a, const Terms& b);

/// Each of `a` joined with each of `b`.
[[nodiscard]] Terms interactions(const Terms& a, const Terms& b);

}  // namespace tcert::statistics
