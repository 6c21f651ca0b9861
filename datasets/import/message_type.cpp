#include "datasets/import/message_type.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <table/diagnostic.hpp>
#include <utility>

#include "datasets/import/definition_text.hpp"

namespace tcert::recording {
namespace {

constexpr std::size_t kMostStructures = 4096;

constexpr std::array<std::pair<std::string_view, FieldKind>, 15> kPrimitives{{
    {"bool", FieldKind::boolean},
    {"byte", FieldKind::uint8},
    {"char", FieldKind::uint8},
    {"int8", FieldKind::int8},
    {"uint8", FieldKind::uint8},
    {"int16", FieldKind::int16},
    {"uint16", FieldKind::uint16},
    {"int32", FieldKind::int32},
    {"uint32", FieldKind::uint32},
    {"int64", FieldKind::int64},
    {"uint64", FieldKind::uint64},
    {"float32", FieldKind::float32},
    {"float64", FieldKind::float64},
    {"string", FieldKind::string},
    {"wstring", FieldKind::wstring},
}};

std::optional<FieldKind> primitive_kind(std::string_view type, bool ros1) noexcept {
  if (ros1 && type == "byte") {
    return FieldKind::int8;
  }
  const auto* found =
      std::ranges::find(kPrimitives, type, &std::pair<std::string_view, FieldKind>::first);
  return found == kPrimitives.end() ? std::nullopt : std::optional(found->second);
}

/// ROS 1's own `time` and `duration`, under the member names of ROS 2.
std::optional<std::string_view> ros1_definition(std::string_view type) noexcept {
  if (type == "time") {
    return "uint32 sec\nuint32 nanosec";
  }
  return type == "duration" ? std::optional<std::string_view>("int32 sec\nint32 nanosec")
                            : std::nullopt;
}

/// Puts together the structures of one type, each once.
class TypeAssembly {
 public:
  TypeAssembly(const DefinitionSections& sections, bool ros1, std::string& problem)
      : sections_(sections), ros1_(ros1), problem_(problem) {}

  /// Index of the structure of `name`; nothing, with the reason, if there can be none.
  std::optional<std::size_t> add(const std::string& name, std::string_view text, std::size_t depth);

  MessageType type;

 private:
  struct Part {
    std::string name;
    std::string_view text;
  };

  std::optional<std::size_t> refuse(std::string reason) {
    problem_ = std::move(reason);
    return std::nullopt;
  }
  [[nodiscard]] std::optional<Part> part_named(std::string_view name,
                                               std::string_view package) const;
  std::optional<Field> resolve(const RawField& raw, const std::string& owner, std::size_t depth);

  const DefinitionSections& sections_;
  bool ros1_;
  std::string& problem_;
  std::map<std::string, std::size_t> known_;  // kOpen while its fields are being read
  std::vector<std::size_t> leaves_;           // fields of each structure that hold no other
  static constexpr std::size_t kOpen = static_cast<std::size_t>(-1);
};

/// The part that `name` means inside a type of `package`.
std::optional<TypeAssembly::Part> TypeAssembly::part_named(std::string_view name,
                                                           std::string_view package) const {
  if (const auto own = ros1_ ? ros1_definition(name) : std::nullopt) {
    return Part{std::string(name), *own};
  }
  std::vector<std::string> candidates;
  if (name.find('/') != std::string_view::npos) {
    candidates.push_back(canonical_type(name));
  } else {
    candidates.push_back(std::string(package) + "/msg/" + std::string(name));
    if (name == "Header") {
      candidates.emplace_back("std_msgs/msg/Header");
    }
  }
  for (std::string& candidate : candidates) {
    if (const auto found = sections_.nested.find(candidate); found != sections_.nested.end()) {
      return Part{std::move(candidate), found->second};
    }
    if (const auto builtin = ros1_ ? std::nullopt : builtin_definition(candidate)) {
      return Part{std::move(candidate), *builtin};
    }
  }
  return std::nullopt;
}

std::optional<Field> TypeAssembly::resolve(const RawField& raw,
                                           const std::string& owner,
                                           std::size_t depth) {
  Field field{raw.name, FieldKind::structure, raw.arity, raw.count, 0};
  if (const auto kind = primitive_kind(raw.type, ros1_)) {
    field.kind = *kind;
    return field;
  }
  const auto part = part_named(raw.type, owner.substr(0, owner.find('/')));
  if (!part) {
    refuse("the type '" + table::shortened(raw.type) + "' of its field '" +
           table::shortened(raw.name) + "' is not in the file, and not built in");
    return std::nullopt;
  }
  const auto index = add(part->name, part->text, depth + 1);
  if (!index) {
    return std::nullopt;
  }
  field.structure = *index;
  return field;
}

std::optional<std::size_t> TypeAssembly::add(const std::string& name,
                                             std::string_view text,
                                             std::size_t depth) {
  if (depth > kDeepestType) {
    return refuse("its definition is nested more than 32 types deep");
  }
  const auto [place, is_new] = known_.try_emplace(name, kOpen);
  if (!is_new) {
    return place->second == kOpen
               ? refuse("the type '" + table::shortened(name) + "' contains itself")
               : std::optional(place->second);
  }
  const std::size_t index = type.structures.size();
  if (index == kMostStructures) {
    return refuse("its definition has more than 4096 types");
  }
  type.structures.push_back({name, {}});
  leaves_.push_back(0);
  const auto raw = raw_fields(text, problem_);
  if (!raw) {
    return std::nullopt;
  }
  std::vector<Field> fields;
  std::size_t leaves = 0;
  for (const RawField& one : *raw) {
    auto field = resolve(one, name, depth);
    if (!field) {
      return std::nullopt;
    }
    leaves += field->kind == FieldKind::structure ? leaves_[field->structure] : 1;
    if (leaves > kMostFields) {
      return refuse("its definition has more than 8192 fields");
    }
    fields.push_back(std::move(*field));
  }
  leaves_[index] = std::max<std::size_t>(leaves, 1);
  type.structures[index].fields = std::move(fields);
  known_[name] = index;
  return index;
}

}  // namespace

std::string canonical_type(std::string_view name) {
  const std::size_t slash = name.find('/');
  if (slash == std::string_view::npos || slash != name.rfind('/') || slash == 0) {
    return std::string(name);
  }
  return std::string(name.substr(0, slash)) + "/msg" + std::string(name.substr(slash));
}

std::optional<MessageType> message_type(std::string_view name,
                                        std::string_view definition,
                                        std::string& problem,
                                        bool ros1) {
  const std::string canonical = canonical_type(name);
  const auto builtin = ros1 ? std::nullopt : builtin_definition(canonical);
  if (definition.empty() && !builtin) {
    problem = "the file has no definition of its type, and none is built in";
    return std::nullopt;
  }
  const auto sections = definition_sections(definition.empty() ? *builtin : definition, problem);
  if (!sections) {
    return std::nullopt;
  }
  // Some writers name the type itself like those that it uses.
  const auto named = sections->nested.find(canonical);
  const bool is_named = named != sections->nested.end();
  TypeAssembly assembly(*sections, ros1, problem);
  if (!assembly.add(canonical, is_named ? named->second : sections->root, 0)) {
    return std::nullopt;
  }
  return std::move(assembly.type);
}

}  // namespace tcert::recording
