#include "cli/runs/written_options.hpp"

#include <fmt/format.h>

#include <utility>

namespace tcert::cli {
namespace {

bool is_written_down(const Option& option) {
  return option.role == OptionRole::shapes || option.role == OptionRole::input;
}

std::string named(const std::string& text, OptionRole role) {
  return role == OptionRole::input ? name_of(text) : text;
}

/// The value as text; of inputs their names.
std::string written_text(const Option& option) {
  const auto* const several = std::get_if<std::vector<std::string>*>(&option.value);
  if (several == nullptr) {
    return named(text_of(option.value), option.role);
  }
  std::vector<std::string> names;
  for (const std::string& one : **several) {
    names.push_back(named(one, option.role));
  }
  return text_of(&names);
}

void append_option(const Option& option, std::vector<ManifestArgument>& arguments) {
  if (const auto* const flag = std::get_if<bool*>(&option.value)) {
    if (**flag) {
      arguments.push_back({"--" + option.name, false});
    }
    return;
  }
  std::vector<std::string> texts;
  if (const auto* const several = std::get_if<std::vector<std::string>*>(&option.value)) {
    texts = **several;
  } else {
    texts.push_back(text_of(option.value));
  }
  for (const std::string& text : texts) {
    arguments.push_back({"--" + option.name, false});
    arguments.push_back({named(text, option.role), option.role == OptionRole::input});
  }
}

}  // namespace

WrittenOptions written_options(const OptionTable& table, const OptionTable& usual) {
  WrittenOptions written;
  for (const Argument& one : table.arguments()) {
    if (!one.value->empty()) {
      written.arguments.push_back({named(*one.value, one.role), one.role == OptionRole::input});
    }
  }
  if (table.rest() != nullptr) {
    for (const std::string& one : *table.rest()) {
      written.arguments.push_back({name_of(one), true});
    }
  }
  for (const Option& option : table.options()) {
    if (!is_written_down(option)) {
      continue;
    }
    const std::string text = text_of(option.value);
    written.options.emplace_back(option.name, written_text(option));
    const Option* const as_usual = usual.find(option.name);
    if (is_given(table.given(), option.name) ||
        (as_usual != nullptr && text_of(as_usual->value) != text)) {
      append_option(option, written.arguments);
    }
  }
  if (const ParameterChanges* const changes = table.parameters()) {
    for (const Settings* const parameters : {&changes->of_file, &changes->of_flags}) {
      for (const auto& [key, value] : *parameters) {
        written.arguments.push_back({"--set", false});
        written.arguments.push_back({fmt::format("{}={}", key, value), false});
      }
    }
  }
  return written;
}

void record(WrittenOptions written, Manifest& manifest) {
  manifest.options = std::move(written.options);
  manifest.arguments = std::move(written.arguments);
}

}  // namespace tcert::cli
