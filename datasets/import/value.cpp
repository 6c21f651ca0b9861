#include "datasets/import/value.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <type_traits>

namespace tcert::recording {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// True of the alternatives of Value::Data whose elements are numbers.
template <class T>
constexpr bool kIsPacked = std::is_same_v<T, Doubles> || std::is_same_v<T, Signed> ||
                           std::is_same_v<T, Unsigned> || std::is_same_v<T, Octets>;

const Value* step_into(const Value& value, const FieldPath::Step& step) noexcept {
  if (step.index) {
    const auto* array = std::get_if<Array>(&value.data);
    return array != nullptr && *step.index < array->size() ? &(*array)[*step.index] : nullptr;
  }
  const auto* object = std::get_if<Object>(&value.data);
  if (object == nullptr) {
    return nullptr;
  }
  const auto member =
      std::ranges::find_if(*object, [&](const Member& m) { return m.name == step.name; });
  return member == object->end() ? nullptr : &member->value;
}

const Value* walk(const Value& root, std::span<const FieldPath::Step> steps) noexcept {
  const Value* value = &root;
  for (const FieldPath::Step& step : steps) {
    value = step_into(*value, step);
    if (value == nullptr) {
      return nullptr;
    }
  }
  return value;
}

std::optional<double> packed_number(const Value& value, std::size_t index) {
  return std::visit(
      [index](const auto& data) -> std::optional<double> {
        using T = std::decay_t<decltype(data)>;
        if constexpr (kIsPacked<T>) {
          return index < data.size() ? std::optional(static_cast<double>(data[index]))
                                     : std::nullopt;
        } else if constexpr (std::is_same_v<T, Flags>) {
          return index < data.values.size() ? std::optional<double>(data.values[index])
                                            : std::nullopt;
        } else {
          return std::nullopt;
        }
      },
      value.data);
}

bool append_mixed(const Array& array, std::vector<double>& out) {
  const std::size_t before = out.size();
  for (const Value& element : array) {
    const auto value = number(element);
    if (!value) {
      out.resize(before);
      return false;
    }
    out.push_back(*value);
  }
  return true;
}

}  // namespace

const Value* find(const Value& root, const FieldPath& path) noexcept {
  return walk(root, path.steps);
}

const Value* find(const Value& root, std::string_view path) {
  const auto parsed = field_path(path);
  return parsed ? find(root, *parsed) : nullptr;
}

std::optional<double> number(const Value& value) {
  return std::visit(
      [](const auto& data) -> std::optional<double> {
        using T = std::decay_t<decltype(data)>;
        if constexpr (std::is_same_v<T, std::monostate>) {
          return kMissing;
        } else if constexpr (std::is_arithmetic_v<T>) {
          return static_cast<double>(data);
        } else {
          return std::nullopt;
        }
      },
      value.data);
}

std::optional<double> number_at(const Value& root, const FieldPath& path) {
  const std::span<const FieldPath::Step> steps = path.steps;
  if (const Value* value = walk(root, steps); value != nullptr) {
    return number(*value);
  }
  if (steps.empty() || !steps.back().index) {
    return std::nullopt;
  }
  const Value* array = walk(root, steps.first(steps.size() - 1));
  return array == nullptr ? std::nullopt : packed_number(*array, *steps.back().index);
}

std::optional<double> number_at(const Value& root, std::string_view path) {
  const auto parsed = field_path(path);
  return parsed ? number_at(root, *parsed) : std::nullopt;
}

std::optional<std::int64_t> integer(const Value& value) noexcept {
  if (const auto* flag = std::get_if<bool>(&value.data)) {
    return *flag ? 1 : 0;
  }
  if (const auto* number = std::get_if<std::int64_t>(&value.data)) {
    return *number;
  }
  const auto* number = std::get_if<std::uint64_t>(&value.data);
  constexpr auto kLargest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  if (number == nullptr || *number > kLargest) {
    return std::nullopt;
  }
  return static_cast<std::int64_t>(*number);
}

const std::string* text(const Value& value) noexcept {
  return std::get_if<std::string>(&value.data);
}

std::size_t size(const Value& value) {
  return std::visit(
      [](const auto& data) -> std::size_t {
        using T = std::decay_t<decltype(data)>;
        if constexpr (kIsPacked<T> || std::is_same_v<T, Array> || std::is_same_v<T, Object>) {
          return data.size();
        } else if constexpr (std::is_same_v<T, Flags>) {
          return data.values.size();
        } else {
          return 0;
        }
      },
      value.data);
}

bool append_numbers(const Value& value, std::vector<double>& out) {
  return std::visit(
      [&out](const auto& data) {
        using T = std::decay_t<decltype(data)>;
        if constexpr (kIsPacked<T>) {
          out.reserve(out.size() + data.size());
          std::ranges::transform(
              data, std::back_inserter(out), [](auto x) { return static_cast<double>(x); });
          return true;
        } else if constexpr (std::is_same_v<T, Flags>) {
          out.insert(out.end(), data.values.begin(), data.values.end());
          return true;
        } else if constexpr (std::is_same_v<T, Array>) {
          return append_mixed(data, out);
        } else {
          return false;
        }
      },
      value.data);
}

}  // namespace tcert::recording
