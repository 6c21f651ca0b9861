#pragma once
/// \file
/// The words that the name of a column is made of.

#include <string>
#include <string_view>
#include <vector>

namespace tcert::table {

/// In lower case, without what stands between them: "field.header.stamp" is field, header, stamp;
/// "x [m]" is x, m; "left_2" is left, 2.
[[nodiscard]] std::vector<std::string> name_words(std::string_view name);

}  // namespace tcert::table
