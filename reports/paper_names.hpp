#pragma once
/// \file
/// The algorithms of the paper's trials in words.

#include <string>
#include <string_view>
#include <vector>

namespace tcert {

struct PaperName {
  std::string_view name;
  std::string_view meaning;  ///< A phrase without a full stop.
};

/// All six, as far as the paper describes them.
[[nodiscard]] const std::vector<PaperName>& paper_names();

/// "CB-V: steers by a camera. ...": a sentence for each, for a footnote or a caption.
[[nodiscard]] std::string paper_names_text();

}  // namespace tcert
