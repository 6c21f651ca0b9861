#pragma once
/// \file
/// Units of foreign columns, as a map names them.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tcert::recording {

/// What one of `unit` ("mm", "deg", "g") is in the unit in which our column `name` ends: 0.001 of
/// "x_m", 0.00981 N of a gram of "left_fsr_n". Case is ignored. Empty if it is no unit of that
/// quantity, or if the column has none.
[[nodiscard]] std::optional<double> unit_scale(std::string_view name, std::string_view unit);

/// The units that the column `name` may be given in: "m", "cm", "mm".
[[nodiscard]] std::vector<std::string> units_of(std::string_view name);

}  // namespace tcert::recording
