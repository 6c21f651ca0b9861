#include "cli/written_options.hpp"

#include <cstdint>
#include <table/csv_write.hpp>
#include <utility>

namespace tcert::cli {
namespace {

std::string as_text(const boost::any& value) {
  if (const auto* text = boost::any_cast<std::string>(&value)) {
    return *text;
  }
  if (const auto* texts = boost::any_cast<std::vector<std::string>>(&value)) {
    std::string joined;
    for (const std::string& one : *texts) {
      joined += (joined.empty() ? "" : " ") + one;
    }
    return joined;
  }
  if (const auto* whole = boost::any_cast<std::int64_t>(&value)) {
    return std::to_string(*whole);
  }
  if (const auto* flag = boost::any_cast<bool>(&value)) {
    return *flag ? "true" : "false";
  }
  std::string text;
  if (const auto* number = boost::any_cast<double>(&value)) {
    table::append_number(text, *number);
  }
  return text;
}

/// The config file of the parameters and --set are written down by what they say.
bool is_written_down(const po::option_description& option) {
  const OptionRole role = role_of(option);
  return (role == OptionRole::shapes || role == OptionRole::input) && option.long_name() != "set" &&
         option.long_name() != "help";
}

void append_option(const std::string& name,
                   const boost::any& value,
                   bool input,
                   std::vector<ManifestArgument>& arguments) {
  if (const auto* flag = boost::any_cast<bool>(&value)) {
    if (*flag) {
      arguments.push_back({"--" + name, false});
    }
    return;
  }
  std::vector<std::string> texts;
  if (const auto* several = boost::any_cast<std::vector<std::string>>(&value)) {
    texts = *several;
  } else {
    texts.push_back(as_text(value));
  }
  for (const std::string& text : texts) {
    arguments.push_back({"--" + name, false});
    arguments.push_back({input ? name_of(text) : text, input});
  }
}

}  // namespace

Settings written_options(const po::variables_map& values, const po::options_description& shown) {
  Settings settings;
  for (const auto& option : shown.options()) {
    if (!is_written_down(*option)) {
      continue;
    }
    const std::string& name = option->long_name();
    std::string text = values.count(name) != 0 ? as_text(values[name].value()) : "";
    if (role_of(*option) == OptionRole::input) {
      text = name_of(text);
    }
    settings.emplace_back(name, std::move(text));
  }
  return settings;
}

std::vector<ManifestArgument> written_arguments(const CommandLine& line,
                                                const po::variables_map& values,
                                                const po::options_description& shown,
                                                const CommonOptions& common) {
  std::vector<ManifestArgument> arguments;
  for (const Positional& one : line.positional) {
    if (!one.value->empty()) {
      const bool input = one.role == OptionRole::input;
      arguments.push_back({input ? name_of(*one.value) : *one.value, input});
    }
  }
  if (line.rest != nullptr) {
    for (const std::string& one : *line.rest) {
      arguments.push_back({name_of(one), true});
    }
  }
  for (const auto& option : shown.options()) {
    const std::string& name = option->long_name();
    if (is_written_down(*option) && values.count(name) != 0 && !values[name].defaulted()) {
      append_option(name, values[name].value(), role_of(*option) == OptionRole::input, arguments);
    }
  }
  for (const Settings* parameters : {&common.file_parameters, &common.flag_parameters}) {
    for (const auto& [key, value] : *parameters) {
      arguments.push_back({"--set", false});
      arguments.push_back({key + "=" + value, false});
    }
  }
  return arguments;
}

}  // namespace tcert::cli
