#include "cli/commands/command_line.hpp"

#include <algorithm>
#include <sstream>
#include <table/atomic_file.hpp>
#include <table/bytes.hpp>
#include <table/nearest_name.hpp>

#include "analysis/study/trials/parameters.hpp"
#include "cli/commands/help_text.hpp"
#include "cli/commands/option_description.hpp"
#include "cli/commands/output.hpp"
#include "cli/commands/terminal_progress.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {
namespace {

namespace po = boost::program_options;

constexpr const char* kSet = "set";
constexpr const char* kConfig = "config";
constexpr const char* kPositional = "positional";

/// What the parser reads by itself: nothing of it reaches the run.
struct Told {
  std::string config;
  Manner& manner;
};

po::options_description common_description(const OptionTable& table, Told& told) {
  po::options_description common =
      description_of("Common options", table, table.own(), table.options().size());
  auto add = common.add_options();
  if (table.has_config_file()) {
    add(kConfig,
        po::value(&told.config)->value_name("FILE"),
        "INI file with the same names as the flags; flags go first");
  }
  if (table.parameters() != nullptr) {
    add(kSet,
        po::value<std::vector<std::string>>()->composing()->value_name("KEY=VALUE"),
        "one parameter, repeatable; also --KEY VALUE and KEY=VALUE in the config file; 'tcert help "
        "parameters' lists them");
  }
  add("quiet", po::bool_switch(&told.manner.quiet), "no progress and no summary on stderr");
  add("help", "print this text");
  return common;
}

/// Every key of the parameter table, taken as text: the table reads it.
po::options_description parameter_description() {
  po::options_description keys;
  for (const study::ParameterInfo& parameter : study::parameter_table()) {
    keys.add_options()(std::string(parameter.key).c_str(), po::value<std::string>());
  }
  return keys;
}

bool is_parameter(std::string_view name) {
  return std::ranges::any_of(study::parameter_table(),
                             [&](const study::ParameterInfo& one) { return one.key == name; });
}

std::vector<std::string> names_of(const po::options_description& options) {
  std::vector<std::string> names;
  for (const auto& option : options.options()) {
    if (option->long_name() != kPositional) {
      names.push_back(option->long_name());
    }
  }
  return names;
}

void take_assignment(const std::string& text, Settings& into) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw UsageError("--set: found '" + text + "', expected key=value");
  }
  into.emplace_back(text.substr(0, equals), text.substr(equals + 1));
}

/// An empty name of a file, as an unset variable of a shell gives it, is not "no file".
void require_names(const po::parsed_options& parsed, const OptionTable& table) {
  for (const auto& option : parsed.options) {
    const Option* const known = table.find(option.string_key);
    const bool names =
        known != nullptr ? known->role != OptionRole::shapes : option.string_key == kConfig;
    if (names && option.value.size() == 1 && option.value.front().empty()) {
      throw UsageError("--" + option.string_key + ": found '', expected a value");
    }
  }
}

void take_parameters(const po::parsed_options& parsed,
                     const OptionTable& table,
                     Settings ParameterChanges::*into) {
  if (table.parameters() == nullptr) {
    return;
  }
  Settings& settings = table.parameters()->*into;
  for (const auto& option : parsed.options) {
    if (option.string_key == kSet) {
      for (const std::string& text : option.value) {
        take_assignment(text, settings);
      }
    } else if (is_parameter(option.string_key) && !option.value.empty()) {
      settings.emplace_back(option.string_key, option.value.front());
    }
  }
}

void read_config(const std::string& path,
                 const po::options_description& all,
                 const OptionTable& table,
                 po::variables_map& values) {
  const table::BytesResult bytes = table::read_raw_file(path);
  if (!bytes.bytes) {
    throw NoInput("cannot read the config file '" + path + "': " + bytes.problem);
  }
  std::istringstream file{std::string(bytes.bytes->view())};
  const auto parsed = po::parse_config_file(file, all, true);
  for (const auto& option : parsed.options) {
    const std::string& key = option.string_key;
    if (option.unregistered || key == kSet || key == kConfig || key == kPositional ||
        key == "help") {
      std::string words = path;
      words.append(": unknown key '").append(key).append("'");
      throw UsageError(words + did_you_mean(key, names_of(all)));
    }
  }
  take_parameters(parsed, table, &ParameterChanges::of_file);
  po::store(parsed, values);
}

void take_arguments(const OptionTable& table, const po::variables_map& values) {
  std::vector<std::string> given;
  if (values.count(kPositional) != 0) {
    given = values[kPositional].as<std::vector<std::string>>();
  }
  const std::vector<Argument>& arguments = table.arguments();
  if (given.size() > arguments.size() && table.rest() != nullptr) {
    table.rest()->assign(given.begin() + static_cast<std::ptrdiff_t>(arguments.size()),
                         given.end());
  } else if (given.size() > arguments.size()) {
    throw UsageError("unexpected argument '" + given[arguments.size()] + "'");
  }
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (i < given.size()) {
      *arguments[i].value = given[i];
    } else if (arguments[i].required) {
      throw UsageError("needs " + arguments[i].name);
    }
  }
}

void check_common(const OptionTable& table) {
  require_values(table);
  if (const Option* const output = table.find("output")) {
    table::require_output_place(text_of(output->value));
  }
}

std::string without_dashes(std::string name) {
  name.erase(0, std::min(name.find_first_not_of('-'), name.size()));
  return name.substr(0, name.find('='));
}

/// "--replicates: found 'abc', expected a whole number".
std::string invalid_value(const po::invalid_option_value& error,
                          const po::options_description& all) {
  const std::string option = error.get_option_name();
  std::string what = error.what();
  const auto begin = what.find("('");
  const auto end = what.find("')", begin);
  const po::option_description* const known = all.find_nothrow(without_dashes(option), false);
  if (begin == std::string::npos || end == std::string::npos || known == nullptr) {
    return what;
  }
  const auto* const value = known->semantic().get();
  std::string expected = "a value of another kind";
  if (dynamic_cast<const po::typed_value<double>*>(value) != nullptr) {
    expected = "a number";
  } else if (dynamic_cast<const po::typed_value<std::int64_t>*>(value) != nullptr) {
    expected = "a whole number";
  }
  return option + ": found '" + what.substr(begin + 2, end - begin - 2) + "', expected " + expected;
}

void print_help(std::string_view help,
                const po::options_description& own,
                const po::options_description& common) {
  std::ostringstream text;
  text << reflowed(help, TerminalProgress(false).width());
  if (!own.options().empty()) {
    text << '\n' << own;
  }
  text << '\n' << common;
  print(text.str());
}

/// The option as Boost was told of it: "FILE (=text)" is the name of a value and its default.
OptionForm form_of(const po::option_description& option, const OptionTable& table) {
  OptionForm form{option.long_name(), "", "", option.description(), {}, false};
  if (option.semantic()->max_tokens() > 0) {
    const std::string value = option.semantic()->name();
    const auto usual = value.find(" (=");
    form.shown = value.substr(0, usual);
    if (usual != std::string::npos) {
      form.usual = value.substr(usual + 3, value.size() - usual - 4);
    }
    form.repeats = option.semantic()->is_composing();
  }
  if (const Option* const known = table.find(form.name)) {
    form.words = known->words;
  }
  return form;
}

}  // namespace

CommandForm form_of(std::string_view help, const OptionTable& table, std::string word) {
  CommandForm form;
  form.word = std::move(word);
  form.help = help;
  Manner manner;
  Told told{"", manner};
  const po::options_description own = description_of(table.heading(), table, 0, table.own());
  const po::options_description common = common_description(table, told);
  form.own = own.options().size();
  for (const po::options_description* const part : {&own, &common}) {
    for (const auto& option : part->options()) {
      form.options.push_back(form_of(*option, table));
    }
  }
  for (const Argument& argument : table.arguments()) {
    form.arguments.push_back({argument.name, argument.words});
  }
  form.takes_parameters = table.parameters() != nullptr;
  return form;
}

bool parse(std::string_view help, const OptionTable& table, Manner& manner, Arguments arguments) {
  Told told{"", manner};
  const po::options_description own = description_of(table.heading(), table, 0, table.own());
  const po::options_description common = common_description(table, told);
  if (std::ranges::any_of(arguments,
                          [](const std::string& one) { return one == "--help" || one == "-h"; })) {
    print_help(help, own, common);
    return false;
  }
  po::options_description all;
  all.add(own).add(common);
  all.add_options()(kPositional, po::value<std::vector<std::string>>());
  if (table.parameters() != nullptr) {
    all.add(parameter_description());
  }
  po::positional_options_description positional;
  positional.add(kPositional, -1);
  po::variables_map values;
  try {
    const auto style =
        po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
    const auto parsed =
        po::command_line_parser(std::vector<std::string>(arguments.begin(), arguments.end()))
            .options(all)
            .positional(positional)
            .style(style)
            .run();
    take_parameters(parsed, table, &ParameterChanges::of_flags);
    require_names(parsed, table);
    po::store(parsed, values);
    // A command may have a --config of its own kind.
    if (table.has_config_file() && values.count(kConfig) != 0) {
      read_config(values[kConfig].as<std::string>(), all, table, values);
    }
    po::notify(values);
  } catch (const po::unknown_option& error) {
    const std::string name = without_dashes(error.get_option_name());
    const auto nearest = table::nearest_name(name, names_of(all));
    throw UsageError("unknown option '" + error.get_option_name() + "'" +
                     (nearest ? "; did you mean '--" + *nearest + "'?" : ""));
  } catch (const po::invalid_option_value& error) {
    throw UsageError(invalid_value(error, all));
  } catch (const po::error& error) {
    throw UsageError(error.what());
  }
  take_arguments(table, values);
  for (const auto& [name, value] : values) {
    if (!value.defaulted()) {
      table.given().push_back(name);
    }
  }
  check_common(table);
  return true;
}

}  // namespace tcert::cli
