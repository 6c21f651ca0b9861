#include <algorithm>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <table/json_shape.hpp>

#include "datasets/import/decoder.hpp"

namespace tcert::recording {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestJson = std::size_t{16} << 20U;
constexpr double kNull = std::numeric_limits<double>::quiet_NaN();

bool fits_signed(const json& value) {
  return value.is_number_integer() &&
         (!value.is_number_unsigned() ||
          value.get<std::uint64_t>() <=
              static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()));
}

Value value_of(const json& tree);

Value array_of(const json& list) {
  const auto is_number_or_null = [](const json& e) { return e.is_number() || e.is_null(); };
  const auto is_number = [](const json& e) { return e.is_number(); };
  if (std::ranges::all_of(list, fits_signed)) {
    return {list.get<Signed>()};
  }
  // Nulls alone tell of no numbers.
  if (std::ranges::all_of(list, is_number_or_null) && std::ranges::any_of(list, is_number)) {
    Doubles numbers;
    numbers.reserve(list.size());
    for (const json& element : list) {
      numbers.push_back(element.is_null() ? kNull : element.get<double>());
    }
    return {std::move(numbers)};
  }
  Array array;
  array.reserve(list.size());
  std::ranges::transform(list, std::back_inserter(array), value_of);
  return {std::move(array)};
}

Value object_of(const json& members) {
  Object object;
  object.reserve(members.size());
  for (const auto& [name, member] : members.items()) {
    object.push_back({name, value_of(member)});
  }
  return {std::move(object)};
}

Value value_of(const json& tree) {
  switch (tree.type()) {
    case json::value_t::boolean:
      return {tree.get<bool>()};
    case json::value_t::number_integer:
    case json::value_t::number_unsigned:
      return fits_signed(tree) ? Value{tree.get<std::int64_t>()} : Value{tree.get<std::uint64_t>()};
    case json::value_t::number_float:
      return {tree.get<double>()};
    case json::value_t::string:
      return {tree.get<std::string>()};
    case json::value_t::array:
      return array_of(tree);
    case json::value_t::object:
      return object_of(tree);
    case json::value_t::null:
    case json::value_t::binary:
    case json::value_t::discarded:
      break;
  }
  return {};
}

}  // namespace

bool decode_json(std::span<const std::byte> text, Value& out, std::string& problem) {
  if (text.size() > kLongestJson) {
    problem = "the JSON message is longer than 16 MiB";
    return false;
  }
  const std::string_view view(reinterpret_cast<const char*>(text.data()), text.size());
  if (const std::string_view shape = table::json_shape_problem(view); !shape.empty()) {
    problem = "the JSON message is " + std::string(shape);
    return false;
  }
  const json tree = json::parse(view, nullptr, false);
  if (tree.is_discarded()) {
    problem = "the message is not JSON";
    return false;
  }
  out = value_of(tree);
  return true;
}

}  // namespace tcert::recording
