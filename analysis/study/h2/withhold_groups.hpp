#pragma once
/// \file
/// What H2 does not say where a group has too few clusters or outcomes.

#include "analysis/study/h2/hypothesis_h2.hpp"

namespace tcert::study {

/// Leaves the estimates of groups that have too few (of all of them if the panel has), and says so:
/// their p-values and intervals go, those of their pairs, and the tests of all groups. Below 12
/// clusters the test that groups are equal goes in any case.
void withhold_if_few(const H2Options& options, H2Panel& panel);

}  // namespace tcert::study
