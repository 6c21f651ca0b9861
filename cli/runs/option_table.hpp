#pragma once
/// \file
/// The options of a request, each declared once: what the command line reads, the help shows, a
/// manifest keeps and `verify` gives back.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "reports/manifest.hpp"

namespace tcert::cli {

/// What an option is to a result.
enum class OptionRole : std::uint8_t {
  shapes,   ///< The result: in the manifest, and again when it is verified.
  input,    ///< A file or folder that is read; in the manifest by its name.
  output,   ///< Where something is written: not what.
  process,  ///< How the result is made, which does not change it: threads, caches.
};

/// Where the value lies in the request; a bool is a switch. What it holds when the table is made is
/// what it is unless given; empty texts, optionals and lists are nothing.
using OptionValue = std::variant<bool*,
                                 double*,
                                 std::int64_t*,
                                 std::string*,
                                 std::optional<std::string>*,
                                 std::optional<double>*,
                                 std::optional<std::int64_t>*,
                                 std::vector<std::string>*>;

struct Option {
  std::string name;
  std::string shown;  ///< For its value in the help: "FILE"; empty of a switch.
  std::string text;   ///< What it is for, as the help has it.
  OptionValue value;
  OptionRole role = OptionRole::shapes;
  std::optional<std::pair<double, double>> range = {};  ///< Of a number, both ends included.
  std::vector<std::string> words = {};                  ///< Those that it may be, for completion.
};

/// The value as text; several are apart by blanks.
[[nodiscard]] std::string text_of(const OptionValue& value);

/// An argument without an option.
struct Argument {
  std::string name;  ///< As the usage line has it: "BUNDLE".
  std::string* value = nullptr;
  bool required = true;
  OptionRole role = OptionRole::shapes;
  std::vector<std::string> words = {};  ///< Those that it may be, if it is one of some.
};

/// Parameters of the certificate and the study that differ from those of the bundle, by their keys.
struct ParameterChanges {
  Settings of_file;   ///< Of the config file, in its order.
  Settings of_flags;  ///< Of --set and of flags, in their order; they go first.
};

class OptionTable {
 public:
  /// \param given takes the names of the options that are set: by flag, file or manifest.
  explicit OptionTable(std::vector<std::string>& given) : given_(&given) {}

  /// Of the own options, in the help.
  [[nodiscard]] const std::string& heading() const noexcept { return heading_; }
  void set_heading(std::string heading) { heading_ = std::move(heading); }

  OptionTable& add(std::string name, bool& value, std::string text);
  /// \pre `value` is of a type that OptionValue points to.
  template <class Value>
  OptionTable& add(std::string name, Value& value, std::string shown, std::string text) {
    return append({std::move(name), std::move(shown), std::move(text), &value});
  }
  OptionTable& add_input(std::string name, std::string& value, std::string shown, std::string text);
  /// Of several files, each with the option's name before it.
  OptionTable& add_inputs(std::string name,
                          std::vector<std::string>& values,
                          std::string shown,
                          std::string text);
  OptionTable& add_output(std::string name,
                          std::string& value,
                          std::string shown,
                          std::string text);
  template <class Value>
  OptionTable& add_process(std::string name, Value& value, std::string shown, std::string text) {
    return append(
        {std::move(name), std::move(shown), std::move(text), &value, OptionRole::process});
  }

  /// The numbers that the option that was declared last may have.
  OptionTable& within(double low, double high);

  /// The words that the option that was declared last may be.
  OptionTable& one_of(std::vector<std::string> words);

  OptionTable& argument(Argument one);
  /// Takes all arguments after those, which are inputs.
  OptionTable& rest(std::vector<std::string>& values);

  /// Options after this are those that commands share.
  OptionTable& common();
  /// Takes --set, and every key of the parameter table as an option of its own.
  OptionTable& parameters(ParameterChanges& changes);
  /// Reads options from an INI file too.
  OptionTable& config_file();

  [[nodiscard]] const std::vector<Option>& options() const noexcept { return options_; }
  [[nodiscard]] const Option* find(std::string_view name) const noexcept;
  /// How many options come before the common ones.
  [[nodiscard]] std::size_t own() const noexcept;
  [[nodiscard]] const std::vector<Argument>& arguments() const noexcept { return arguments_; }
  [[nodiscard]] std::vector<std::string>* rest() const noexcept { return rest_; }
  [[nodiscard]] ParameterChanges* parameters() const noexcept { return parameters_; }
  [[nodiscard]] bool has_config_file() const noexcept { return config_file_; }
  [[nodiscard]] std::vector<std::string>& given() const noexcept { return *given_; }

  /// Leaves only options, of the own ones, that `wanted` of their name.
  template <class Wanted>
  void keep_own(const Wanted& wanted) {
    const std::size_t before = own();
    std::vector<Option> kept;
    for (std::size_t i = 0; i < options_.size(); ++i) {
      if (i >= before || wanted(options_[i].name)) {
        kept.push_back(options_[i]);
      }
    }
    own_ = before - (options_.size() - kept.size());
    options_ = std::move(kept);
  }

 private:
  OptionTable& append(Option option);

  std::string heading_ = "Options";
  std::vector<Option> options_;
  std::optional<std::size_t> own_;
  std::vector<Argument> arguments_;
  std::vector<std::string>* rest_ = nullptr;
  ParameterChanges* parameters_ = nullptr;
  bool config_file_ = false;
  std::vector<std::string>* given_;
};

/// \throws UsageError for a number out of the range of its option.
void require_ranges(const OptionTable& table);

/// \throws UsageError unless low <= value <= high.
void require_range(std::string_view option, double value, double low, double high);

/// True if `name` is among the options that were set.
[[nodiscard]] bool is_given(const std::vector<std::string>& given, std::string_view name) noexcept;

}  // namespace tcert::cli
