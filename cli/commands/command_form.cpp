#include "cli/commands/command_form.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "cli/commands/command.hpp"

namespace tcert::cli {
namespace {

/// The first sentence of a help text, up to a colon, as a summary: "make a bundle from ...".
std::string first_words(const std::string& help) {
  std::string text = help.substr(0, help.find("\n\n"));
  std::ranges::replace(text, '\n', ' ');
  text += ' ';
  text.resize(std::min(text.find(". "), text.find(": ")));
  text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

}  // namespace

bool OptionForm::is_path() const {
  constexpr std::array<std::string_view, 4> kPaths{"FILE", "PATH", "DIR", "FOLDER"};
  return std::ranges::find(kPaths, shown) != kPaths.end();
}

std::vector<NamedForm> all_forms() {
  std::vector<NamedForm> all;
  for (const Command* const command : commands()) {
    for (CommandForm& form : command->forms()) {
      NamedForm named{std::string(command->name), std::string(command->summary), std::move(form)};
      if (!named.form.word.empty()) {
        named.name += ' ' + named.form.word;
        named.summary = first_words(named.form.help);
      }
      all.push_back(std::move(named));
    }
  }
  return all;
}

}  // namespace tcert::cli
