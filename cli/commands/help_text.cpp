#include "cli/commands/help_text.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "reports/text_width.hpp"

namespace tcert::cli {
namespace {

/// Paragraphs are apart by empty lines.
std::vector<TextLines> paragraphs_of(std::string_view text) {
  std::vector<TextLines> paragraphs(1);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    if (!line.empty()) {
      paragraphs.back().emplace_back(line);
    } else if (!paragraphs.back().empty()) {
      paragraphs.emplace_back();
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  std::erase_if(paragraphs, [](const TextLines& one) { return one.empty(); });
  return paragraphs;
}

std::string without_indentation(const std::string& line) {
  return line.substr(std::min(line.find_first_not_of(' '), line.size()));
}

/// "Cost: that of" -> "That of"; a heading that says more, "Cost in CPU time:", stays.
TextLines without_heading(TextLines lines) {
  for (const std::string_view heading : {"Cost: ", "Exit code: ", "Exit codes: "}) {
    if (lines[0].starts_with(heading)) {
      lines[0].erase(0, heading.size());
      lines[0][0] = static_cast<char>(std::toupper(static_cast<unsigned char>(lines[0][0])));
    }
  }
  return lines;
}

/// "  word   what it is": what goes on in the next line stands below "what".
struct HangingText {
  std::string lead;  ///< Up to there.
  std::string text;
};

HangingText taken_apart(const std::string& line) {
  const std::size_t word = std::min(line.find_first_not_of(' '), line.size());
  const std::size_t gap = line.find("  ", word);
  const std::size_t text = gap == std::string::npos ? word : line.find_first_not_of(' ', gap);
  return word == 0 ? HangingText{"", line} : HangingText{line.substr(0, text), line.substr(text)};
}

/// Lines that go on are joined: those as far in as the text before, or, without a list, all.
std::vector<HangingText> hanging_of(const TextLines& lines) {
  std::vector<HangingText> all;
  for (const std::string& line : lines) {
    const std::size_t in = std::min(line.find_first_not_of(' '), line.size());
    if (!all.empty() && in == tcert::width_of(all.back().lead)) {
      all.back().text += ' ' + line.substr(in);
    } else {
      all.push_back(taken_apart(line));
    }
  }
  return all;
}

std::string in_lines(const HangingText& one, std::size_t width) {
  constexpr std::size_t kLeast = 20;
  const std::size_t in = tcert::width_of(one.lead);
  std::string out;
  for (const std::string& part : broken(one.text, std::max(width, in + kLeast) - in)) {
    out += (out.empty() ? one.lead : std::string(in, ' ')) + part + '\n';
  }
  return out;
}

}  // namespace

std::string reflowed(std::string_view text, std::size_t width) {
  if (width == 0) {
    return std::string(text);
  }
  std::string out;
  for (const TextLines& lines : paragraphs_of(text)) {
    out += out.empty() ? "" : "\n";
    if (lines[0] == "Example:" || lines[0].starts_with("Usage:")) {
      for (const std::string& line : lines) {
        out += line + '\n';
      }
    } else {
      for (const HangingText& one : hanging_of(lines)) {
        out += in_lines(one, width);
      }
    }
  }
  return out;
}

HelpText help_text(std::string_view text) {
  const std::string_view usage = "Usage:";
  HelpText help;
  for (TextLines& lines : paragraphs_of(text)) {
    if (lines[0].starts_with(usage)) {
      lines[0].erase(0, usage.size());
      for (const std::string& line : lines) {
        help.usage.push_back(without_indentation(line));
      }
    } else if (lines[0] == "Example:") {
      for (std::size_t i = 1; i < lines.size(); ++i) {
        help.examples.push_back(lines[i].substr(std::min<std::size_t>(2, lines[i].size())));
      }
    } else if (lines[0].starts_with("Exit code")) {
      help.exits.push_back(without_heading(std::move(lines)));
    } else if (lines[0].starts_with("Cost")) {
      help.cost = without_heading(std::move(lines));
    } else {
      help.purpose.push_back(std::move(lines));
    }
  }
  return help;
}

}  // namespace tcert::cli
