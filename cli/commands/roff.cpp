#include "cli/commands/roff.hpp"

namespace tcert::cli {
namespace {

std::string_view escape_of(char c) {
  switch (c) {
    case '\\':
      return "\\e";
    case '-':
      return "\\-";
    case '\'':
      return "\\(aq";
    case '`':
      return "\\(ga";
    case '^':
      return "\\(ha";
    case '~':
      return "\\(ti";
    default:
      return {};
  }
}

bool stands_as_it_is(const std::string& line) { return line.starts_with("  "); }

}  // namespace

std::string roff_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const std::string_view escape = escape_of(c);
    if (escape.empty()) {
      out += c;
    } else {
      out += escape;
    }
  }
  return out;
}

std::string roff_line(std::string_view text) {
  return (text.starts_with('.') ? "\\&" : "") + roff_escaped(text) + '\n';
}

std::string roff_literal(const std::vector<std::string>& lines) {
  std::string out = ".nf\n";
  for (const std::string& line : lines) {
    out += roff_line(line);
  }
  return out + ".fi\n";
}

std::string roff_paragraph(const std::vector<std::string>& lines) {
  std::string out = ".PP\n";
  std::vector<std::string> literal;
  const auto flush = [&] {
    if (!literal.empty()) {
      out += ".RS 2\n" + roff_literal(literal) + ".RE\n";
      literal.clear();
    }
  };
  for (const std::string& line : lines) {
    if (stands_as_it_is(line)) {
      literal.push_back(line.substr(2));
    } else {
      flush();
      out += roff_line(line);
    }
  }
  flush();
  return out;
}

std::string roff_entry(const std::string& term, std::string_view text) {
  return ".TP\n" + term + '\n' + roff_line(text);
}

std::string roff_bold(std::string_view text) { return "\\fB" + roff_escaped(text) + "\\fR"; }

std::string roff_italic(std::string_view text) { return "\\fI" + roff_escaped(text) + "\\fR"; }

}  // namespace tcert::cli
