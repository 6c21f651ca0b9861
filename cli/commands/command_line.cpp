#include "cli/options.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <table/atomic_file.hpp>
#include <table/bytes.hpp>
#include <table/csv_write.hpp>
#include <table/nearest_name.hpp>

#include "analysis/study/trials/parameters.hpp"
#include "cli/errors.hpp"
#include "cli/output.hpp"
#include "cli/written_options.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kSet = "set";
constexpr std::string_view kConfig = "config";
constexpr std::string_view kPositional = "positional";

po::options_description common_description(unsigned use, CommonOptions& o) {
  po::options_description text("Common options");
  auto add = text.add_options();
  if ((use & uses_output) != 0) {
    add("output", output(o.output, "PATH"), "where to write; appears only when it is whole");
  }
  if ((use & uses_format) != 0) {
    add("format",
        po::value(&o.format)->value_name("WORD")->default_value(o.format),
        "of what is printed: text, md, csv, json, jsonl or tex");
  }
  if ((use & uses_seed) != 0) {
    add("seed",
        po::value(&o.seed)->value_name("N")->default_value(o.seed),
        "of all random draws; another seed is another sample");
  }
  if ((use & uses_threads) != 0) {
    add("threads",
        process(o.threads, "N")->default_value(o.threads),
        "0 takes all cores; the results are the same for any number");
  }
  if ((use & uses_trials) != 0) {
    add("trials",
        po::value(&o.trials)->value_name("IDS"),
        "only these: trial ids or patterns with * and ?, comma between");
  }
  if ((use & uses_logs) != 0) {
    add("strict", po::bool_switch(&o.strict), "stop at the first rejected trial");
    add("repair",
        po::bool_switch(&o.repair),
        "drop or merge bad rows, counted, instead of rejecting their trial");
  }
  if ((use & (uses_logs | uses_decimal_comma)) != 0) {
    add("decimal-comma",
        po::bool_switch(&o.decimal_comma),
        "numbers like 1,5 in files whose separator is the semicolon");
  }
  if ((use & (uses_config | uses_parameters)) != 0) {
    add("config",
        process(o.config, "FILE"),
        "INI file with the same names as the flags; flags go first");
  }
  if ((use & uses_parameters) != 0) {
    add("set",
        po::value<std::vector<std::string>>()->composing()->value_name("KEY=VALUE"),
        "one parameter, repeatable; also --KEY VALUE and KEY=VALUE in the config file; 'tcert help "
        "parameters' lists them");
  }
  add("quiet", process_switch(o.quiet), "no progress and no summary on stderr");
  add("help", "print this text");
  return text;
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
  const auto table = study::parameter_table();
  return std::any_of(
      table.begin(), table.end(), [&](const study::ParameterInfo& one) { return one.key == name; });
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
void require_names(const po::parsed_options& parsed, const po::options_description& all) {
  for (const auto& option : parsed.options) {
    const auto* const known = all.find_nothrow(option.string_key, false);
    const bool names = known != nullptr && role_of(*known) != OptionRole::shapes;
    if (names && option.value.size() == 1 && option.value.front().empty()) {
      throw UsageError("--" + option.string_key + ": found '', expected a value");
    }
  }
}

void take_parameters(const po::parsed_options& parsed, Settings& into) {
  for (const auto& option : parsed.options) {
    if (option.string_key == kSet) {
      for (const std::string& text : option.value) {
        take_assignment(text, into);
      }
    } else if (is_parameter(option.string_key) && !option.value.empty()) {
      into.emplace_back(option.string_key, option.value.front());
    }
  }
}

void read_config(const std::string& path,
                 const po::options_description& all,
                 po::variables_map& values,
                 CommonOptions& common) {
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
      throw UsageError(path + ": unknown key '" + key + "'" + did_you_mean(key, names_of(all)));
    }
  }
  take_parameters(parsed, common.file_parameters);
  po::store(parsed, values);
}

void take_positional(const CommandLine& line, const po::variables_map& values) {
  std::vector<std::string> given;
  if (values.count(std::string(kPositional)) != 0) {
    given = values[std::string(kPositional)].as<std::vector<std::string>>();
  }
  if (given.size() > line.positional.size() && line.rest != nullptr) {
    line.rest->assign(given.begin() + static_cast<std::ptrdiff_t>(line.positional.size()),
                      given.end());
  } else if (given.size() > line.positional.size()) {
    throw UsageError("unexpected argument '" + given[line.positional.size()] + "'");
  }
  for (std::size_t i = 0; i < line.positional.size(); ++i) {
    if (i < given.size()) {
      *line.positional[i].value = given[i];
    } else if (line.positional[i].required) {
      throw UsageError("needs " + line.positional[i].name);
    }
  }
}

void check_common(const CommonOptions& common) {
  require_range("seed", static_cast<double>(common.seed), 0, 9.3e18);
  require_range("threads", static_cast<double>(common.threads), 0, 1024);
  if (!table_format_from(common.format)) {
    throw UsageError("--format: found '" + common.format +
                     "', expected text, md, csv, json, jsonl or tex" +
                     did_you_mean(common.format, {"text", "md", "csv", "json", "jsonl", "tex"}));
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
  const std::string what = error.what();
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

}  // namespace

TableFormat CommonOptions::table_format() const { return *table_format_from(format); }

bool parse(const CommandLine& line, CommonOptions& common, Arguments arguments) {
  po::options_description shown;
  shown.add(line.own).add(common_description(line.common, common));
  if (std::find(arguments.begin(), arguments.end(), "--help") != arguments.end()) {
    std::ostringstream text;
    text << line.help;
    if (!line.own.options().empty()) {
      text << '\n' << line.own;
    }
    CommonOptions ignored;
    text << '\n' << common_description(line.common, ignored);
    print(text.str());
    return false;
  }
  po::options_description all;
  all.add(shown);
  all.add_options()(std::string(kPositional).c_str(), po::value<std::vector<std::string>>());
  if ((line.common & uses_parameters) != 0) {
    all.add(parameter_description());
  }
  po::positional_options_description positional;
  positional.add(std::string(kPositional).c_str(), -1);
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
    take_parameters(parsed, common.flag_parameters);
    require_names(parsed, all);
    po::store(parsed, values);
    // A command may have a --config of its own kind.
    if ((line.common & (uses_config | uses_parameters)) != 0 &&
        values.count(std::string(kConfig)) != 0) {
      read_config(values[std::string(kConfig)].as<std::string>(), all, values, common);
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
  take_positional(line, values);
  check_common(common);
  table::require_output_place(common.output);
  common.effective = written_options(values, shown);
  common.arguments = written_arguments(line, values, shown, common);
  for (const auto& [name, value] : values) {
    if (!value.defaulted()) {
      common.given.push_back(name);
    }
  }
  return true;
}

void record(const CommonOptions& common, Manifest& manifest) {
  manifest.options = common.effective;
  manifest.arguments = common.arguments;
}

void require_range(std::string_view option, double value, double low, double high) {
  if (value >= low && value <= high) {
    return;
  }
  std::string text = "--" + std::string(option) + ": found ";
  if (std::isnan(value)) {
    text += "nan";
  } else {
    table::append_number(text, value);
  }
  text += ", expected a value from ";
  table::append_number(text, low);
  text += " to ";
  table::append_number(text, high);
  throw UsageError(text);
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& known) {
  const auto nearest = table::nearest_name(name, known);
  return nearest ? "; did you mean '" + *nearest + "'?" : "";
}

}  // namespace tcert::cli
