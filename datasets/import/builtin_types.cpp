#include <algorithm>
#include <array>

#include "datasets/import/message_type.hpp"

namespace tcert::recording {
namespace {

struct BuiltinType {
  std::string_view name;
  std::string_view definition;
};

#define TCERT_MESSAGE(name, definition) BuiltinType{name, definition},
constexpr std::array kBuiltinTypes{
#include "datasets/import/builtin_types.def"
};
#undef TCERT_MESSAGE

}  // namespace

std::optional<std::string_view> builtin_definition(std::string_view name) noexcept {
  const auto* found = std::ranges::find(kBuiltinTypes, name, &BuiltinType::name);
  return found == kBuiltinTypes.end() ? std::nullopt : std::optional(found->definition);
}

}  // namespace tcert::recording
