#include "cli/runs/option_table.hpp"

#include <algorithm>
#include <cmath>
#include <table/csv_write.hpp>
#include <utility>

#include "cli/runs/errors.hpp"

namespace tcert::cli {
namespace {

struct AsText {
  std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
  std::string operator()(const double* value) const {
    std::string text;
    table::append_number(text, *value);
    return text;
  }
  std::string operator()(const std::int64_t* value) const { return std::to_string(*value); }
  std::string operator()(const std::string* value) const { return *value; }
  std::string operator()(const std::optional<std::string>* value) const {
    return value->value_or("");
  }
  std::string operator()(const std::optional<double>* value) const {
    return *value ? (*this)(&**value) : "";
  }
  std::string operator()(const std::optional<std::int64_t>* value) const {
    return *value ? std::to_string(**value) : "";
  }
  std::string operator()(const std::vector<std::string>* values) const {
    std::string text;
    for (const std::string& one : *values) {
      text += (text.empty() ? "" : " ") + one;
    }
    return text;
  }
};

}  // namespace

std::string text_of(const OptionValue& value) { return std::visit(AsText{}, value); }

OptionTable& OptionTable::append(Option option) {
  options_.push_back(std::move(option));
  return *this;
}

OptionTable& OptionTable::add(std::string name, bool& value, std::string text) {
  return append({std::move(name), "", std::move(text), &value});
}

OptionTable& OptionTable::add_input(std::string name,
                                    std::string& value,
                                    std::string shown,
                                    std::string text) {
  return append({std::move(name), std::move(shown), std::move(text), &value, OptionRole::input});
}

OptionTable& OptionTable::add_inputs(std::string name,
                                     std::vector<std::string>& values,
                                     std::string shown,
                                     std::string text) {
  return append({std::move(name), std::move(shown), std::move(text), &values, OptionRole::input});
}

OptionTable& OptionTable::add_output(std::string name,
                                     std::string& value,
                                     std::string shown,
                                     std::string text) {
  return append({std::move(name), std::move(shown), std::move(text), &value, OptionRole::output});
}

OptionTable& OptionTable::within(double low, double high) {
  options_.back().range = {low, high};
  return *this;
}

OptionTable& OptionTable::one_of(std::vector<std::string> words) {
  options_.back().words = std::move(words);
  return *this;
}

OptionTable& OptionTable::argument(Argument one) {
  arguments_.push_back(std::move(one));
  return *this;
}

OptionTable& OptionTable::rest(std::vector<std::string>& values) {
  rest_ = &values;
  return *this;
}

OptionTable& OptionTable::common() {
  own_ = options_.size();
  return *this;
}

OptionTable& OptionTable::parameters(ParameterChanges& changes) {
  parameters_ = &changes;
  config_file_ = true;
  return *this;
}

OptionTable& OptionTable::config_file() {
  config_file_ = true;
  return *this;
}

const Option* OptionTable::find(std::string_view name) const noexcept {
  const auto found = std::ranges::find(options_, name, &Option::name);
  return found == options_.end() ? nullptr : &*found;
}

std::size_t OptionTable::own() const noexcept { return own_.value_or(options_.size()); }

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

void require_ranges(const OptionTable& table) {
  for (const Option& option : table.options()) {
    if (!option.range) {
      continue;
    }
    const auto& [low, high] = *option.range;
    if (const auto* const number = std::get_if<double*>(&option.value)) {
      require_range(option.name, **number, low, high);
    } else if (const auto* const whole = std::get_if<std::int64_t*>(&option.value)) {
      require_range(option.name, static_cast<double>(**whole), low, high);
    } else if (const auto* const some = std::get_if<std::optional<double>*>(&option.value)) {
      require_range(option.name, (*some)->value_or(low), low, high);
    } else if (const auto* const few = std::get_if<std::optional<std::int64_t>*>(&option.value)) {
      const std::optional<std::int64_t>& count = **few;
      require_range(option.name, count ? static_cast<double>(*count) : low, low, high);
    }
  }
}

bool is_given(const std::vector<std::string>& given, std::string_view name) noexcept {
  return std::ranges::find(given, name) != given.end();
}

}  // namespace tcert::cli
