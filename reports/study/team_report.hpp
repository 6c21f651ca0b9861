#pragma once
/// \file
/// The report of `study federation`.

#include <cstdint>
#include <vector>

#include "analysis/study/federation/federation_study.hpp"
#include "reports/fit/fit_report.hpp"

namespace tcert {

[[nodiscard]] FitReport team_report(const std::vector<study::FederationOutcome>& worlds,
                                    std::uint64_t seed);

}  // namespace tcert
