#include <table/json_shape.hpp>

#include <array>

namespace tcert::table {

std::string_view json_shape_problem(std::string_view text) noexcept {
  std::array<std::size_t, kDeepestJson + 1> keys{};  // of what is open, by depth
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') {
        ++i;
      } else if (c == '"') {
        in_string = false;
      }
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kDeepestJson) {
        return kNestedTooDeeply;
      }
      keys[depth] = 0;
    } else if ((c == ']' || c == '}') && depth > 0) {
      --depth;
    } else if (c == ':' && ++keys[depth] > kMostJsonKeys) {
      return kTooManyKeys;
    }
  }
  return {};
}

}  // namespace tcert::table
