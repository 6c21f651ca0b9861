#pragma once
/// \file
/// Message types of ROS: what fields of what kind, in what order.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tcert::recording {

/// What a field holds. `byte` and `char` are uint8 (as in ROS 2; in ROS 1 `byte` is int8).
enum class FieldKind : std::uint8_t {
  boolean,
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64,
  string,
  wstring,
  structure,  ///< Another type: Field::structure.
};

enum class Arity : std::uint8_t {
  scalar,
  fixed,     ///< T[N]: exactly `count` elements.
  sequence,  ///< T[], T[<=N]: at most `count` elements, if that is above 0.
};

struct Field {
  std::string name;
  FieldKind kind = FieldKind::boolean;
  Arity arity = Arity::scalar;
  std::size_t count = 0;
  std::size_t structure = 0;  ///< Index into MessageType::structures, if the kind is `structure`.
};

struct Structure {
  std::string name;  ///< Canonical: "geometry_msgs/msg/Pose".
  std::vector<Field> fields;
};

/// A type with all that it is made of. Never recursive, never deeper than kDeepestType, and never
/// of more than kMostFields fields when flattened (an empty structure counts as one).
struct MessageType {
  std::vector<Structure> structures;  ///< The first is the type itself.
};

inline constexpr std::size_t kDeepestType = 32;
inline constexpr std::size_t kMostFields = 8192;

/// "pkg/msg/Type" of "pkg/Type" (ROS 1) and of itself; anything else as it is.
[[nodiscard]] std::string canonical_type(std::string_view name);

/// The type `name` by its definition: the text of a .msg file, followed by those of the types that
/// it uses, each after a line of '=' and a line "MSG: pkg/Type". Types that neither the text nor
/// the built-in table has are a problem. With an empty `definition`, the built-in type of that
/// name. `ros1` reads `byte` as int8 and `Header` with its `seq`. \returns nothing, with the reason
/// in `problem`, if it cannot be read.
[[nodiscard]] std::optional<MessageType> message_type(std::string_view name,
                                                      std::string_view definition,
                                                      std::string& problem,
                                                      bool ros1 = false);

/// The definition that is built in for the canonical `name`, in ros2msg text without its nested
/// types; nothing if there is none.
[[nodiscard]] std::optional<std::string_view> builtin_definition(std::string_view name) noexcept;

/// One row for `check`: the path of a field that holds no other, and its kind.
struct FieldName {
  std::string path;  ///< "pose.pose.position.x", "ranges[]", "transforms[].header.frame_id"
  std::string kind;  ///< "float64", "float32[]", "float64[36]", "int8[<=3]", "string"
};

/// Every field that holds no other, in the order of the message.
[[nodiscard]] std::vector<FieldName> field_names(const MessageType& type);

}  // namespace tcert::recording
