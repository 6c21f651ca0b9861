#pragma once
/// \file
/// What a run found, in sentences: what people read before any table.

#include <optional>
#include <statistics/basics/interval.hpp>
#include <string>
#include <vector>

#include "reports/table.hpp"

namespace tcert {

struct Finding {
  std::string about;     ///< "H1, success, landmark panel".
  std::string verdict;   ///< "supported", "contradicted", "not decided"; empty of a description.
  std::string evidence;  ///< The numbers behind it: one sentence or two, with full stops.
};

/// A table `findings` of them; the rules by which verdicts are made are its footnotes.
[[nodiscard]] Table findings_table(const std::vector<Finding>& findings,
                                   std::vector<std::string> rules = {});

/// A line each, "H1, success, landmark panel: supported. Evidence.", then the rules; broken at
/// `width` characters if that is above 0. Empty without findings.
/// \pre the table is one of `findings_table`.
[[nodiscard]] std::string findings_text(const Table& findings, std::size_t width = 0);

/// "0.066 [0.031, 0.101]", the value alone without an interval, NA without a value.
[[nodiscard]] std::string in_words(const std::optional<double>& value,
                                   const std::optional<statistics::Interval>& interval,
                                   int decimals = 3);

}  // namespace tcert
