#pragma once
/// \file
/// What a command takes, by itself: what manual pages and completions are made from.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cli/runs/option_table.hpp"

namespace tcert::cli {

struct OptionForm {
  std::string name;   ///< Without dashes.
  std::string shown;  ///< For its value: "FILE"; empty of a switch.
  std::string usual;  ///< Its default; empty if there is none to be shown.
  std::string text;
  std::vector<std::string> words;  ///< Those that it may be, if they are known.
  bool repeats = false;

  [[nodiscard]] bool is_path() const;
};

struct ArgumentForm {
  std::string name;
  std::vector<std::string> words;
};

/// A command, or what it is with a word behind it: "import carmen".
struct CommandForm {
  std::string word;  ///< "carmen"; empty of the command itself.
  std::string help;
  std::vector<OptionForm> options;  ///< Its own, then those that commands share.
  std::size_t own = 0;              ///< How many are its own.
  std::vector<ArgumentForm> arguments;
  bool takes_parameters = false;  ///< Every parameter is an option, too.
};

/// As parse() reads and prints it.
[[nodiscard]] CommandForm form_of(std::string_view help,
                                  const OptionTable& table,
                                  std::string word = {});

/// A form under its whole name.
struct NamedForm {
  std::string name;  ///< "certify", "import carmen".
  std::string summary;
  CommandForm form;
};

/// Of every command, in their order, each followed by its forms with a word.
[[nodiscard]] std::vector<NamedForm> all_forms();

}  // namespace tcert::cli
