#include "cli/commands/overview.hpp"

#include <algorithm>

#include "cli/commands/command.hpp"
#include "cli/commands/exit_meanings.hpp"
#include "cli/commands/help_topics.hpp"

namespace tcert::cli {
namespace {

/// Words with a line end where the line would be longer.
std::string filled(const std::string& text) {
  constexpr std::size_t kWidth = 100;
  std::string out;
  std::size_t line = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::size_t length = end - begin;
    if (line > 0) {
      const bool fits = line + 1 + length <= kWidth;
      out += fits ? ' ' : '\n';
      line = fits ? line + 1 : 0;
    }
    out.append(text, begin, length);
    line += length;
    begin = end + 1;
  }
  return out + '\n';
}

std::string padded(std::string_view name) {
  std::string text(name);
  text.resize(12, ' ');
  return "  " + text;
}

std::string exit_codes() {
  std::string text;
  for (const ExitMeaning& one : exit_meanings()) {
    text += text.empty() ? "Exit codes: " : "; ";
    text += std::string(one.codes) + ' ' + std::string(one.meaning);
  }
  return text + '.';
}

}  // namespace

std::string overview() {
  std::string text(kToolPurpose);
  text += "\n\nUsage: tcert COMMAND [options]\n\nExample:\n  ";
  text += kToolExample;
  text += "\n\nCommands:\n";
  for (const Command* const command : commands()) {
    text += padded(command->name) + std::string(command->summary) + '\n';
  }
  text += '\n' + filled(exit_codes()) +
          "\n'tcert COMMAND --help' describes one command; 'tcert help TOPIC':\n";
  for (const HelpTopic& topic : help_topics()) {
    text += padded(topic.name) + std::string(topic.summary) + '\n';
  }
  return text + padded("man") + "the manual pages\n" + padded("completion") +
         "completion of commands and options for bash, zsh and fish\n";
}

}  // namespace tcert::cli
