// Any bytes as a terrain file: the reader neither throws nor reads outside, says why it rejects,
// and what it takes reads back to the same bits.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "datasets/terrain_file.hpp"
#include "fuzz/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcert;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const TerrainHeader header :
       {TerrainHeader::detect, TerrainHeader::yes, TerrainHeader::no}) {
    const auto result = read_terrain(table::Bytes::copy_of(text), {"fuzz.csv", header});
    fuzz::require(result.terrain.has_value() != table::has_error(result.diagnostics),
                  "no terrain without a reason");
    if (!result.terrain) {
      continue;
    }
    TerrainGrid terrain = *result.terrain;
    terrain.header.clear();
    for (const double v : terrain.values) {
      fuzz::require(std::isnan(v) || std::abs(v) <= kLargestTerrainValue, "a value or a gap");
    }
    fuzz::require(terrain.values.size() == static_cast<std::size_t>(terrain.rows) *
                                               static_cast<std::size_t>(terrain.columns),
                  "a rectangle");
    const auto again =
        read_terrain(table::Bytes::copy_of(terrain_text(terrain)),
                     {"again.csv", TerrainHeader::no, TerrainFormat::grid, {false, {}}});
    fuzz::require(again.terrain && again.terrain->rows == terrain.rows &&
                      std::ranges::equal(again.terrain->values,
                                         terrain.values,
                                         [](double a, double b) {
                                           return a == b || (std::isnan(a) && std::isnan(b));
                                         }),
                  "the same bits read back");
  }
  return 0;
}
