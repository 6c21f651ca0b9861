#pragma once
/// \file
/// One function per format of a table; callers use render() of table.hpp.

#include <string>

#include "reports/table.hpp"

namespace tcert {

[[nodiscard]] std::string render_text(const Table& table, std::size_t width);
[[nodiscard]] std::string render_markdown(const Table& table);
[[nodiscard]] std::string render_latex(const Table& table);
[[nodiscard]] std::string render_csv(const Table& table);
[[nodiscard]] std::string render_json(const Table& table);
[[nodiscard]] std::string render_jsonl(const Table& table);

}  // namespace tcert
