#include <terrain/grid.hpp>

namespace tcert::terrain {

std::size_t count(const CellSet& set) noexcept {
  std::size_t members = 0;
  for (const std::uint8_t member : set) {
    members += member;
  }
  return members;
}

}  // namespace tcert::terrain
