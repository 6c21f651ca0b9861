#pragma once
/// \file
/// The manual pages, made from the help texts, the tables of options and the topics of the help.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tcert::cli {

struct ManualPage {
  std::string name;  ///< "tcert-import-carmen".
  int section = 1;
  std::string text;

  /// "man1/tcert.1".
  [[nodiscard]] std::string path() const;
};

/// By what every page begins: only what begins so is replaced.
inline constexpr std::string_view kManualMark = ".\\\" Made by 'tcert help man'.\n";

/// tcert(1), a page a command in section 1, a page a topic in section 7.
[[nodiscard]] std::vector<ManualPage> manual();

}  // namespace tcert::cli
