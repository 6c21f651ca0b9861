#pragma once
/// \file
/// The letters and short words of the page, explained where they first stand.

#include <string>
#include <string_view>
#include <vector>

namespace tcert {

struct GlossaryEntry {
  std::string term;
  std::string meaning;  ///< With a full stop.
};

/// The entries whose words stand in `text`, in the order in which one needs the other.
/// `with_algorithms`: the algorithms are the paper's.
[[nodiscard]] std::vector<GlossaryEntry> glossary_of(std::string_view text, bool with_algorithms);

/// True if `word` stands in `text` with no letter, digit or underscore beside it.
[[nodiscard]] bool has_word(std::string_view text, std::string_view word);

}  // namespace tcert
