#include "cli/runs/read_request.hpp"

#include <algorithm>
#include <charconv>
#include <table/path_name.hpp>
#include <table/temporary_name.hpp>
#include <utility>

namespace tcert::cli {
namespace {

using Words = std::span<const ManifestArgument>;

/// Reads the words of a manifest into a request, from the first to the last.
class Reader {
 public:
  Reader(std::string command, const OptionTable& table, const FindInput& find)
      : command_(std::move(command)), table_(table), find_(find) {}

  void take(Words words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      const ManifestArgument& word = words[i];
      if (word.is_input) {
        take_input(word.text);
      } else if (word.text.starts_with("--")) {
        const bool has_value =
            take_option(word.text.substr(2), i + 1 < words.size() ? &words[i + 1] : nullptr);
        i += has_value ? 1 : 0;
      } else {
        take_word(word.text);
      }
    }
    for (const Argument& one : table_.arguments()) {
      const bool is_input = one.role == OptionRole::input;
      std::size_t& taken = is_input ? inputs_ : words_;
      if (taken > 0) {
        --taken;
      } else if (one.required) {
        refuse("no " + one.name);
      }
    }
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw NotReproducible("found " + what + ", which '" + command_ +
                          "' does not write down of itself: nothing is run");
  }

  /// The next argument of that role; null if there is none.
  const Argument* next(OptionRole role) {
    const auto& arguments = table_.arguments();
    std::size_t& taken = role == OptionRole::input ? inputs_ : words_;
    std::size_t seen = 0;
    for (const Argument& one : arguments) {
      if ((one.role == OptionRole::input) == (role == OptionRole::input) && seen++ == taken) {
        ++taken;
        return &one;
      }
    }
    return nullptr;
  }

  [[nodiscard]] std::optional<std::string> found(const std::string& name, bool first) const {
    if (!table::is_path_step(name) || table::is_temporary_name(name)) {
      refuse("the input '" + name + "'");
    }
    return find_(name, first);
  }

  void take_input(const std::string& name) {
    const Argument* const into = next(OptionRole::input);
    if (into == nullptr && table_.rest() == nullptr) {
      refuse("the input '" + name + "'");
    }
    if (const auto path = found(name, !std::exchange(has_input_, true))) {
      if (into != nullptr) {
        *into->value = *path;
      } else {
        table_.rest()->push_back(*path);
      }
    }
  }

  void take_word(const std::string& word) {
    const Argument* const into = next(OptionRole::shapes);
    if (into == nullptr || std::ranges::find(into->words, word) == into->words.end()) {
      refuse("the word '" + word + "'");
    }
    *into->value = word;
  }

  /// True if the next word is the option's value.
  bool take_option(const std::string& name, const ManifestArgument* value) {
    if (name == "set" && table_.parameters() != nullptr && value != nullptr && !value->is_input) {
      const auto equals = value->text.find('=');
      if (equals == std::string::npos) {
        refuse("the parameter '" + value->text + "'");
      }
      table_.parameters()->of_flags.emplace_back(value->text.substr(0, equals),
                                                 value->text.substr(equals + 1));
      return true;
    }
    const Option* const option = table_.find(name);
    if (option == nullptr ||
        (option->role != OptionRole::shapes && option->role != OptionRole::input)) {
      refuse("the option '--" + name + "'");
    }
    const bool is_list = std::holds_alternative<std::vector<std::string>*>(option->value);
    if (!is_list && is_given(table_.given(), name)) {
      refuse("the option '--" + name + "' twice");
    }
    table_.given().push_back(name);
    if (const auto* const flag = std::get_if<bool*>(&option->value)) {
      **flag = true;
      return false;
    }
    if (value == nullptr || value->is_input != (option->role == OptionRole::input)) {
      refuse("the option '--" + name + "' without its value");
    }
    if (option->role != OptionRole::input) {
      set(*option, value->text);
    } else if (const auto path = found(value->text, false)) {
      set(*option, *path);
    }
    return true;
  }

  void set(const Option& option, const std::string& text) const {
    const auto number = [&](auto& into) {
      const char* const end = text.data() + text.size();
      const auto [stop, error] = std::from_chars(text.data(), end, into);
      if (error != std::errc{} || stop != end) {
        refuse("the option '--" + option.name + "' with the value '" + text + "'");
      }
    };
    if (auto* const* const several = std::get_if<std::vector<std::string>*>(&option.value)) {
      (*several)->push_back(text);
    } else if (auto* const* const one = std::get_if<std::string*>(&option.value)) {
      **one = text;
    } else if (auto* const* const some = std::get_if<std::optional<std::string>*>(&option.value)) {
      **some = text;
    } else if (auto* const* const real = std::get_if<double*>(&option.value)) {
      number(**real);
    } else if (auto* const* const whole = std::get_if<std::int64_t*>(&option.value)) {
      number(**whole);
    } else if (auto* const* const perhaps = std::get_if<std::optional<double>*>(&option.value)) {
      number((*perhaps)->emplace());
    } else if (auto* const* const count =
                   std::get_if<std::optional<std::int64_t>*>(&option.value)) {
      number((*count)->emplace());
    }
  }

  std::string command_;
  const OptionTable& table_;
  const FindInput& find_;
  std::size_t inputs_ = 0;
  std::size_t words_ = 0;
  bool has_input_ = false;
};

}  // namespace

void read_request(const std::string& command,
                  const OptionTable& table,
                  Words words,
                  const FindInput& find) {
  Reader(command, table, find).take(words);
}

}  // namespace tcert::cli
