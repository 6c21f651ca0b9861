#include "datasets/import/definition_text.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>
#include <table/diagnostic.hpp>

namespace tcert::recording {
namespace {

constexpr std::string_view kBlanks = " \t\r";
constexpr std::size_t kShortestRule = 5;  // of '=', between two sections
constexpr std::size_t kMostFieldsOfOne = 4096;
constexpr std::size_t kLongestName = 256;

std::string_view take_line(std::string_view& text) noexcept {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

std::string_view without_blanks(std::string_view text) noexcept {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}

bool is_rule(std::string_view line) noexcept {
  const std::string_view bare = without_blanks(line);
  return bare.size() >= kShortestRule && bare.find_first_not_of('=') == std::string_view::npos;
}

/// "pkg/Type" of a line "MSG: pkg/Type"; empty if it is none.
std::string_view named_by(std::string_view line) noexcept {
  constexpr std::string_view kMark = "MSG:";
  const std::string_view bare = without_blanks(line);
  return bare.starts_with(kMark) ? without_blanks(bare.substr(kMark.size())) : std::string_view{};
}

bool is_name_character(char c) noexcept {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool is_field_name(std::string_view name) noexcept {
  return !name.empty() && name.size() <= kLongestName &&
         std::ranges::all_of(name, is_name_character);
}

bool is_type_name(std::string_view name) noexcept {
  return !name.empty() &&
         std::ranges::all_of(name, [](char c) { return is_name_character(c) || c == '/'; });
}

/// A number without sign that fills `text`.
std::optional<std::size_t> whole_number(std::string_view text) noexcept {
  std::size_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && stop == end ? std::optional(value) : std::nullopt;
}

/// Takes what stands in the last brackets of "type[N]", "type[]", "type[<=N]" into `field`.
bool take_brackets(std::string_view& type, RawField& field) {
  if (!type.ends_with(']')) {
    return true;
  }
  const std::size_t open = type.rfind('[');
  if (open == std::string_view::npos) {
    return false;
  }
  std::string_view inside = type.substr(open + 1, type.size() - open - 2);
  type = type.substr(0, open);
  field.arity = Arity::sequence;
  if (inside.empty()) {
    return true;
  }
  if (inside.starts_with("<=")) {
    inside.remove_prefix(2);
  } else {
    field.arity = Arity::fixed;
  }
  const auto count = whole_number(inside);
  field.count = count.value_or(0);
  return field.count > 0;
}

/// "string<=N" and "wstring<=N": the bound is the writer's affair.
bool take_string_bound(std::string_view& type) {
  const std::size_t bound = type.find("<=");
  if (bound == std::string_view::npos) {
    return true;
  }
  const bool is_whole = whole_number(type.substr(bound + 2)).has_value();
  type = type.substr(0, bound);
  return is_whole && (type == "string" || type == "wstring");
}

enum class LineKind { nothing, field, wrong };

LineKind read_line(std::string_view line, RawField& field) {
  line = without_blanks(line);
  if (line.empty() || line.front() == '#') {
    return LineKind::nothing;
  }
  const std::size_t type_end = line.find_first_of(kBlanks);
  if (type_end == std::string_view::npos) {
    return LineKind::wrong;
  }
  std::string_view type = line.substr(0, type_end);
  std::string_view rest = without_blanks(line.substr(type_end));
  const std::size_t name_end = std::min(rest.find_first_of(" \t\r=#"), rest.size());
  const std::string_view name = rest.substr(0, name_end);
  if (without_blanks(rest.substr(name_end)).starts_with('=')) {
    return LineKind::nothing;  // A constant has no bytes in a message; nor has a default.
  }
  if (!take_brackets(type, field) || !take_string_bound(type) || !is_type_name(type) ||
      !is_field_name(name)) {
    return LineKind::wrong;
  }
  field.type = type;
  field.name = name;
  return LineKind::field;
}

}  // namespace

std::optional<DefinitionSections> definition_sections(std::string_view text, std::string& problem) {
  if (text.size() > kLongestDefinition) {
    problem = "its definition is longer than 1 MiB";
    return std::nullopt;
  }
  DefinitionSections sections;
  const char* begin = text.data();
  std::optional<std::string> name;  // of the section that is open; the root has none
  const auto close = [&](const char* end) {
    const std::string_view body(begin, static_cast<std::size_t>(end - begin));
    if (name) {
      sections.nested.try_emplace(*name, body);
    } else {
      sections.root = body;
    }
  };
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    if (!is_rule(line)) {
      continue;
    }
    close(line.data());
    const std::string_view named = named_by(take_line(text));
    if (named.empty()) {
      problem = "a part of its definition is not named 'MSG: package/Type' (IDL is not read)";
      return std::nullopt;
    }
    name = canonical_type(named);
    begin = text.data();
  }
  close(text.data());
  return sections;
}

std::optional<std::vector<RawField>> raw_fields(std::string_view section, std::string& problem) {
  std::vector<RawField> fields;
  while (!section.empty()) {
    const std::string_view line = take_line(section);
    RawField field;
    if (without_blanks(line) == "---") {
      problem = "it is defined as a service or an action, not as a message";
      return std::nullopt;
    }
    const LineKind kind = read_line(line, field);
    if (kind == LineKind::wrong || fields.size() == kMostFieldsOfOne) {
      problem = kind == LineKind::wrong ? "the line '" + table::shortened(without_blanks(line)) +
                                              "' of its definition is no field"
                                        : "a type of its definition has more than 4096 fields";
      return std::nullopt;
    }
    if (kind == LineKind::field) {
      fields.push_back(std::move(field));
    }
  }
  return fields;
}

}  // namespace tcert::recording
