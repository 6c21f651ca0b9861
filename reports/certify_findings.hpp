#pragma once
/// \file
/// What certifying a study found, in sentences.

#include <span>

#include "analysis/study/trials/feature_table.hpp"
#include "reports/table.hpp"

namespace tcert {

/// In how many successes and failures a certificate was issued, why not in the others, and where
/// the early certificate lies; of a few trials, each by itself and then in how many. If no success
/// has a certificate, or no trial, the reason that holds for most of them.
[[nodiscard]] Table certify_findings(std::span<const study::FeatureRow> rows);

}  // namespace tcert
