#pragma once
/// \file
/// A help text taken apart: its paragraphs tell by their first words what they are.

#include <string>
#include <string_view>
#include <vector>

namespace tcert::cli {

using TextLines = std::vector<std::string>;

struct HelpText {
  TextLines usage;                 ///< Without "Usage:".
  std::vector<TextLines> purpose;  ///< Paragraphs that are none of the others.
  TextLines examples;              ///< Without "Example:" and indentation.
  std::vector<TextLines> exits;    ///< Without "Exit code:".
  TextLines cost;                  ///< Without "Cost:".
};

/// The text in lines of at most `width` characters: paragraphs are filled, examples stay as they
/// are, so that they can be copied. 0: as it is.
[[nodiscard]] std::string reflowed(std::string_view text, std::size_t width);

[[nodiscard]] HelpText help_text(std::string_view text);

}  // namespace tcert::cli
