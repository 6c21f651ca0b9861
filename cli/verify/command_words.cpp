#include "cli/verify/command_words.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>
#include <table/path_name.hpp>
#include <utility>

namespace tcert::cli {
namespace {

enum class Takes : std::uint8_t { nothing, text, input };

struct AllowedOption {
  std::string_view name;
  Takes takes = Takes::text;
};

struct AllowedCommand {
  const Command* command;
  std::string_view first_word;          ///< Of what belongs to the command: "terrain"; or empty.
  std::vector<std::string_view> words;  ///< Of which one comes next: "h1"; none if empty.
  bool several_inputs = false;          ///< Arguments without an option.
  std::vector<AllowedOption> options;
};

using Options = std::vector<AllowedOption>;

Options joined(std::initializer_list<Options> parts) {
  Options all;
  for (const Options& part : parts) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

const std::vector<AllowedCommand>& allowed_commands() {
  static const Options kFormat = {{"format"}};
  static const Options kSeed = {{"seed"}};
  static const Options kLogs = {{"trials"},
                                {"set"},
                                {"strict", Takes::nothing},
                                {"repair", Takes::nothing},
                                {"decimal-comma", Takes::nothing}};
  static const Options kLaws = {{"laws"}, {"betas"}, {"tracking-error", Takes::input}};
  static const Options kBatch = {
      {"cells", Takes::input}, {"cluster"}, {"strata"}, {"replicates"}, {"table"}};
  static const std::vector<AllowedCommand> all = {
      {&kSimulate,
       "",
       {},
       false,
       joined({kSeed,
               {{"trials"},
                {"effect"},
                {"native-rates", Takes::nothing},
                {"micro-study", Takes::nothing}}})},
      {&kSimulate,
       "terrain",
       {},
       false,
       joined({kSeed, {{"rows"}, {"columns"}, {"mean"}, {"length-scale"}, {"lipschitz"}}})},
      {&kImport,
       "barn",
       {},
       false,
       {{"trials", Takes::input},
        {"metrics", Takes::input},
        {"planners"},
        {"same-port", Takes::nothing}}},
      {&kCertify,
       "",
       {},
       true,
       joined({kFormat,
               kLogs,
               {{"ticks", Takes::nothing},
                {"no-series", Takes::nothing},
                {"ray-margins", Takes::nothing},
                {"truth", Takes::nothing}}})},
      {&kReplay,
       "",
       {},
       true,
       joined({kFormat, kLogs, kLaws, {{"replan", Takes::nothing}, {"series", Takes::nothing}}})},
      {&kAblate, "", {}, true, joined({kFormat, kSeed, kLogs, kBatch})},
      {&kSweep,
       "",
       {},
       true,
       joined({kFormat, kSeed, kLogs, kBatch, {{"grid"}, {"sensitivity", Takes::nothing}}})},
      {&kGate,
       "",
       {},
       true,
       joined({kFormat, kSeed, kLogs, {{"level"}, {"replicates"}, {"table"}}})},
      {&kHypotheses,
       "",
       {"h1", "h2", "h3"},
       true,
       joined({kFormat,
               kSeed,
               kLogs,
               kLaws,
               {{"features", Takes::input},
                {"replays", Takes::input},
                {"no-time-rounding", Takes::nothing},
                {"within"},
                {"interval"},
                {"predictor"},
                {"baselines"},
                {"success"},
                {"time"},
                {"cluster"},
                {"strata"},
                {"landmark"},
                {"limit"},
                {"replicates"},
                {"folds"},
                {"level"},
                {"group"},
                {"margin"},
                {"permutations"},
                {"table"},
                {"gated"},
                {"lead"},
                {"loss-margin"}}})},
      {&kFit,
       "",
       {"glm", "cox", "km", "glmm", "roc", "concordance", "calibration"},
       true,
       joined({kFormat,
               kSeed,
               {{"data", Takes::input},
                {"decimal-comma", Takes::nothing},
                {"robust", Takes::nothing},
                {"no-profile", Takes::nothing},
                {"no-time-rounding", Takes::nothing},
                {"firth", Takes::nothing},
                {"profile", Takes::nothing},
                {"drop1", Takes::nothing},
                {"reverse", Takes::nothing},
                {"formula"},
                {"cluster"},
                {"strata"},
                {"weights"},
                {"ref"},
                {"level"},
                {"table"},
                {"ties"},
                {"transform"},
                {"residuals"},
                {"curves"},
                {"folds"},
                {"predicted"},
                {"quadrature"},
                {"interval"},
                {"times"},
                {"rho"},
                {"cause"},
                {"pair-weight"},
                {"partial"},
                {"bootstrap"}}})},
      {&kWorld,
       "",
       {},
       true,
       joined({kFormat,
               {{"clearance"},
                {"body-width"},
                {"min-turn-radius"},
                {"no-curvature", Takes::nothing},
                {"step"},
                {"cell-size"},
                {"start"},
                {"goal"},
                {"bounds"}}})},
      {&kExplore,
       "",
       {},
       true,
       joined({kSeed,
               {{"config", Takes::input},
                {"obstacles", Takes::input},
                {"look-ahead", Takes::nothing},
                {"adaptive", Takes::nothing},
                {"trust-model", Takes::nothing},
                {"rules"},
                {"start"},
                {"goal"},
                {"mode"},
                {"header"},
                {"terrain-format"},
                {"nodata"},
                {"threshold"},
                {"lipschitz"},
                {"confidence"},
                {"beta"},
                {"expanders"},
                {"kernel-variance"},
                {"kernel-length-scale"},
                {"kernel-mean"},
                {"noise-variance"},
                {"noise-bound"},
                {"start-radius"},
                {"motion"},
                {"simplification"},
                {"robot-radius"},
                {"travel-weight"},
                {"max-steps"},
                {"frames"}}})},
      {&kFigures, "", {}, true, {{"trials"}}},
      {&kReport, "", {}, true, {{"bundle", Takes::input}, {"title"}, {"ticks"}}}};
  return all;
}

std::string shown_word(const std::string& word) { return "'" + word + "'"; }

const AllowedCommand& allowed(const std::string& name, const std::string& first_word) {
  const auto& all = allowed_commands();
  const auto called = [&](const AllowedCommand& one) { return one.command->name == name; };
  const auto exact = std::ranges::find_if(all, [&](const AllowedCommand& one) {
    return called(one) && !one.first_word.empty() && one.first_word == first_word;
  });
  if (exact != all.end()) {
    return *exact;
  }
  const auto plain = std::ranges::find_if(
      all, [&](const AllowedCommand& one) { return called(one) && one.first_word.empty(); });
  if (plain == all.end()) {
    throw NotReproducible("its manifest names the command " + shown_word(name) +
                          ", which makes no result that can be made again");
  }
  return *plain;
}

/// Reads the words of a manifest from the first to the last.
class Reader {
 public:
  Reader(const AllowedCommand& allowed, const FindInput& find) : allowed_(allowed), find_(find) {
    result_.command = allowed.command;
  }

  void take(std::span<const ManifestArgument> arguments) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const ManifestArgument& argument = arguments[i];
      if (argument.is_input) {
        take_input(argument.text);
      } else if (argument.text.starts_with("--")) {
        const bool has_value = take_option(argument.text.substr(2),
                                           i + 1 < arguments.size() ? &arguments[i + 1] : nullptr);
        i += has_value ? 1 : 0;
      } else {
        take_word(argument.text);
      }
    }
  }

  [[nodiscard]] CommandWords result() && { return std::move(result_); }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw NotReproducible("its manifest has " + what + ", which '" +
                          std::string(allowed_.command->name) +
                          "' does not write into a manifest: nothing is run");
  }

  void require_name(const std::string& name) const {
    if (!table::is_path_step(name) || table::is_temporary_name(name)) {
      refuse("the input " + shown_word(name));
    }
  }

  void take_input(const std::string& name) {
    if (!allowed_.several_inputs) {
      refuse("the input " + shown_word(name));
    }
    require_name(name);
    if (const auto path = find_(name, !std::exchange(has_input_, true))) {
      result_.words.push_back(*path);
    }
  }

  void take_word(const std::string& word) {
    const auto& words = allowed_.words;
    if (has_word_ || std::ranges::find(words, word) == words.end()) {
      refuse("the word " + shown_word(word));
    }
    has_word_ = true;
    result_.words.push_back(word);
  }

  /// True if the next argument is the option's value.
  bool take_option(const std::string& name, const ManifestArgument* value) {
    const auto option = std::ranges::find_if(
        allowed_.options, [&](const AllowedOption& one) { return one.name == name; });
    if (option == allowed_.options.end()) {
      refuse("the option " + shown_word("--" + name));
    }
    if (option->takes == Takes::nothing) {
      result_.words.push_back("--" + name);
      return false;
    }
    if (value == nullptr || value->is_input != (option->takes == Takes::input)) {
      refuse("the option " + shown_word("--" + name) + " without its value");
    }
    if (option->takes == Takes::text && value->text.empty()) {
      result_.words.insert(result_.words.end(), {"--" + name, ""});
      return true;
    }
    if (option->takes == Takes::text) {
      result_.words.push_back("--" + name + "=" + value->text);
      return true;
    }
    require_name(value->text);
    if (const auto path = find_(value->text, false)) {
      result_.words.push_back("--" + name + "=" + *path);
    }
    return true;
  }

  const AllowedCommand& allowed_;
  const FindInput& find_;
  CommandWords result_;
  bool has_input_ = false;
  bool has_word_ = false;
};

}  // namespace

CommandWords command_words(const WrittenResult& manifest, const FindInput& find) {
  std::span<const ManifestArgument> arguments = *manifest.arguments;
  std::string name = manifest.command;
  std::string first_word;
  if (const auto space = name.find(' '); space != std::string::npos) {
    first_word = name.substr(space + 1);
    name.resize(space);
  } else if (!arguments.empty() && !arguments.front().is_input) {
    first_word = arguments.front().text;
  }
  const AllowedCommand& command = allowed(name, first_word);
  if (!command.first_word.empty() && !arguments.empty() && !arguments.front().is_input &&
      arguments.front().text == command.first_word) {
    arguments = arguments.subspan(1);
  }
  Reader reader(command, find);
  reader.take(arguments);
  CommandWords result = std::move(reader).result();
  if (!command.first_word.empty()) {
    result.words.insert(result.words.begin(), std::string(command.first_word));
  }
  return result;
}

}  // namespace tcert::cli
