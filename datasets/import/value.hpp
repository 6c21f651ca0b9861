#pragma once
/// \file
/// A decoded message: a tree whose integers are exact and whose arrays of numbers are packed.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tcert::recording {

struct Value;
struct Member;

using Object = std::vector<Member>;        ///< In the order of the definition, or of the JSON text.
using Array = std::vector<Value>;          ///< Of objects, texts, or (JSON) of anything mixed.
using Doubles = std::vector<double>;       ///< float32[], float64[]
using Signed = std::vector<std::int64_t>;  ///< int8[] ... int64[]
using Unsigned = std::vector<std::uint64_t>;  ///< uint16[] ... uint64[]
using Octets = std::vector<std::uint8_t>;     ///< uint8[], byte[], char[]

/// bool[]; each element 0 or 1.
struct Flags {
  std::vector<std::uint8_t> values;
  [[nodiscard]] bool operator==(const Flags&) const = default;
};

/// Nothing (JSON's null), a scalar, packed numbers, or a tree. Both float types are doubles, and
/// each float32 is exact in one.
struct Value {
  using Data = std::variant<std::monostate,
                            bool,
                            std::int64_t,
                            std::uint64_t,
                            double,
                            std::string,
                            Doubles,
                            Signed,
                            Unsigned,
                            Octets,
                            Flags,
                            Array,
                            Object>;
  Data data;

  [[nodiscard]] bool operator==(const Value&) const = default;
};

struct Member {
  std::string name;
  Value value;

  [[nodiscard]] bool operator==(const Member&) const = default;
};

/// The way to a value: "pose.pose.position.x", "ranges[3]", "transforms[0].header.frame_id".
struct FieldPath {
  struct Step {
    std::string name;                  ///< Of a member; empty for an index into an array.
    std::optional<std::size_t> index;  ///< 0-based.
  };
  std::vector<Step> steps;
};

/// Empty unless `text` is names with dots between them, each with any number of [INDEX] behind it.
[[nodiscard]] std::optional<FieldPath> field_path(std::string_view text);

/// The value at `path`, or nullptr if there is none. An element of packed numbers is no Value of
/// its own: number_at() reads it.
[[nodiscard]] const Value* find(const Value& root, const FieldPath& path) noexcept;
[[nodiscard]] const Value* find(const Value& root, std::string_view path);

/// A scalar as a double: a bool is 0 or 1, nothing is NaN; empty for a text, an array, an object.
/// An integer beyond 2^53 is rounded; `data` has it exactly.
[[nodiscard]] std::optional<double> number(const Value& value);

/// number() of the value at `path`, elements of packed numbers too; empty if there is no number.
[[nodiscard]] std::optional<double> number_at(const Value& root, const FieldPath& path);
[[nodiscard]] std::optional<double> number_at(const Value& root, std::string_view path);

/// A scalar of an integer type (or a bool), exactly; empty for anything else and beyond int64.
[[nodiscard]] std::optional<std::int64_t> integer(const Value& value) noexcept;

/// A text; nullptr for anything else.
[[nodiscard]] const std::string* text(const Value& value) noexcept;

/// Elements of an array of any kind, members of an object; 0 for a scalar.
[[nodiscard]] std::size_t size(const Value& value);

/// Appends the numbers of an array of any kind to `out` (JSON's null as NaN); false, and nothing is
/// appended, if it is no array or an element is no number.
bool append_numbers(const Value& value, std::vector<double>& out);

}  // namespace tcert::recording
