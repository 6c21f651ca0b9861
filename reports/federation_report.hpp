#pragma once
/// \file
/// What several robots know together, as a report.

#include <federation/federate.hpp>
#include <vector>

#include "reports/fit/fit_report.hpp"

namespace tcert {

/// A file of a submap as it was given.
struct GivenSubmap {
  std::string file;
  std::size_t bytes = 0;
};

/// T_H and its way, the sources with their own values, and the union as an attachment.
[[nodiscard]] FitReport federation_report(const federation::Submap& merged,
                                          const federation::Federation& found,
                                          const std::vector<GivenSubmap>& given);

}  // namespace tcert
