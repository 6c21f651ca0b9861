#pragma once
/// \file
/// Cells and settings as JSON values. Internal to reports.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "reports/table.hpp"

namespace tcert {

/// Keys in the order in which they were added.
using OrderedJson = nlohmann::ordered_json;

/// One row as an object; an estimate gives three keys. Missing is null.
[[nodiscard]] OrderedJson json_row(const Table& table, const std::vector<TableCell>& cells);

/// A setting: null, true, false or a number where its text is one, else the text.
[[nodiscard]] OrderedJson setting_value(const std::string& text);

/// Ended by a newline; `indent` of -1 is one line. Text from a log need not be UTF-8: what is not
/// becomes U+FFFD instead of an exception.
[[nodiscard]] std::string dumped(const OrderedJson& json, int indent);

}  // namespace tcert
