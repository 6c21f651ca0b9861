#include <statistics/model/call_arguments.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tcert::statistics {
namespace {

std::vector<Expression> members_of(const Expression& expression) {
  return expression.is_call("c") ? expression.arguments : std::vector<Expression>{expression};
}

}  // namespace

std::optional<double> constant_of(const Expression& expression) {
  if (expression.kind == Expression::Kind::number) {
    return expression.value;
  }
  if (expression.kind == Expression::Kind::column && expression.name == "Inf") {
    return std::numeric_limits<double>::infinity();
  }
  if ((expression.is_call("-") || expression.is_call("+") || expression.is_call("(")) &&
      expression.arguments.size() == 1) {
    const std::optional<double> inside = constant_of(expression.arguments.front());
    return inside && expression.is_call("-") ? std::optional(-*inside) : inside;
  }
  return std::nullopt;
}

CallArguments::CallArguments(const Expression& call, std::vector<std::string> names)
    : text_(to_string(call)), names_(std::move(names)), values_(names_.size(), nullptr) {
  std::vector<const Expression*> unnamed;
  for (const Expression& argument : call.arguments) {
    if (!argument.is_call("=")) {
      unnamed.push_back(&argument);
      continue;
    }
    const auto found = std::find(names_.begin(), names_.end(), argument.arguments[0].name);
    if (found == names_.end()) {
      fail("no argument '" + argument.arguments[0].name + "'");
    }
    const Expression*& value = values_[static_cast<std::size_t>(found - names_.begin())];
    if (value != nullptr) {
      fail("'" + *found + "' stands twice");
    }
    value = &argument.arguments[1];
  }
  auto place = values_.begin();
  for (const Expression* const one : unnamed) {
    place = std::find(place, values_.end(), nullptr);
    if (place == values_.end()) {
      fail("too many arguments");
    }
    *place = one;
  }
}

void CallArguments::fail(const std::string& problem) const {
  throw FormulaError("'" + text_ + "': " + problem);
}

const Expression* CallArguments::find(const std::string& name) const noexcept {
  const auto found = std::find(names_.begin(), names_.end(), name);
  return found == names_.end() ? nullptr
                               : values_[static_cast<std::size_t>(found - names_.begin())];
}

const Expression& CallArguments::required(const std::string& name) const {
  const Expression* const value = find(name);
  if (value == nullptr) {
    fail("it lacks '" + name + "'");
  }
  return *value;
}

std::optional<std::int64_t> CallArguments::whole(const std::string& name) const {
  const Expression* const value = find(name);
  if (value == nullptr) {
    return std::nullopt;
  }
  constexpr double kMost = 1000.0;
  const std::optional<double> number = constant_of(*value);
  if (!number || *number != std::floor(*number) || *number < 1.0 || *number > kMost) {
    fail(name + " is a whole number from 1 to 1000");
  }
  return static_cast<std::int64_t>(*number);
}

std::vector<double> CallArguments::numbers(const std::string& name) const {
  std::vector<double> all;
  if (const Expression* const value = find(name)) {
    for (const Expression& member : members_of(*value)) {
      const std::optional<double> number = constant_of(member);
      if (!number) {
        fail(name + " is a number or c() of them");
      }
      all.push_back(*number);
    }
  }
  return all;
}

std::vector<std::string> CallArguments::texts(const std::string& name) const {
  std::vector<std::string> all;
  if (const Expression* const value = find(name)) {
    for (const Expression& member : members_of(*value)) {
      if (member.kind != Expression::Kind::text) {
        fail(name + " is a text or c() of them");
      }
      all.push_back(member.name);
    }
  }
  return all;
}

bool CallArguments::truth(const std::string& name, bool usual) const {
  const Expression* const value = find(name);
  if (value == nullptr) {
    return usual;
  }
  const bool is_true = value->name == "TRUE" || value->name == "T";
  if (value->kind != Expression::Kind::column ||
      (!is_true && value->name != "FALSE" && value->name != "F")) {
    fail(name + " is TRUE or FALSE");
  }
  return is_true;
}

}  // namespace tcert::statistics
