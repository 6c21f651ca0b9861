#pragma once
/// \file
/// Text as the language of manual pages (man(7)).

#include <string>
#include <string_view>
#include <vector>

namespace tcert::cli {

/// Characters that groff would take for something else; a hyphen stays one that can be copied.
[[nodiscard]] std::string roff_escaped(std::string_view text);

/// A line as it is, though it begins with a dot.
[[nodiscard]] std::string roff_line(std::string_view text);

/// Lines as they stand, not filled.
[[nodiscard]] std::string roff_literal(const std::vector<std::string>& lines);

/// Lines that are filled; those that begin with two blanks stand as they are.
[[nodiscard]] std::string roff_paragraph(const std::vector<std::string>& lines);

/// An entry of a list: `term`, which is roff already, and its text.
[[nodiscard]] std::string roff_entry(const std::string& term, std::string_view text);

[[nodiscard]] std::string roff_bold(std::string_view text);
[[nodiscard]] std::string roff_italic(std::string_view text);

}  // namespace tcert::cli
