#include <array>

#include "datasets/import/message_type.hpp"

namespace tcert::recording {
namespace {

constexpr std::array<std::string_view, 13> kKindNames{"bool",
                                                      "int8",
                                                      "uint8",
                                                      "int16",
                                                      "uint16",
                                                      "int32",
                                                      "uint32",
                                                      "int64",
                                                      "uint64",
                                                      "float32",
                                                      "float64",
                                                      "string",
                                                      "wstring"};

/// "[36]", "[]", "[<=3]" or nothing.
std::string brackets_of(const Field& field) {
  switch (field.arity) {
    case Arity::scalar:
      return {};
    case Arity::fixed:
      return "[" + std::to_string(field.count) + "]";
    case Arity::sequence:
      break;
  }
  return field.count == 0 ? "[]" : "[<=" + std::to_string(field.count) + "]";
}

void append_names(const MessageType& type,
                  std::size_t structure,
                  const std::string& prefix,
                  std::vector<FieldName>& out) {
  for (const Field& field : type.structures[structure].fields) {
    const std::string path = prefix + field.name + (field.arity == Arity::scalar ? "" : "[]");
    if (field.kind == FieldKind::structure) {
      append_names(type, field.structure, path + ".", out);
    } else {
      const std::string_view kind = kKindNames[static_cast<std::size_t>(field.kind)];
      out.push_back({path, std::string(kind) + brackets_of(field)});
    }
  }
}

}  // namespace

std::vector<FieldName> field_names(const MessageType& type) {
  std::vector<FieldName> names;
  if (!type.structures.empty()) {
    append_names(type, 0, {}, names);
  }
  return names;
}

}  // namespace tcert::recording
