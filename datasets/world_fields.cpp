#include "datasets/world_fields.hpp"

#include <array>

namespace tcert {
namespace {

constexpr auto kWorldFields = std::to_array<FileField>({
    {"world", "format", "", FieldNeed::required, "\"tcert-world\""},
    {"world", "version", "", FieldNeed::required, "1"},
    {"world", "synthetic", "", FieldNeed::required, "true of a world made by a program"},
    {"world", "seed", "", FieldNeed::optional, "of that program"},
    {"world", "name", "", FieldNeed::optional, "how tables call it; else the file's name"},
    {"world", "bounds", "", FieldNeed::required, "a rectangle; all outside of it is occupied"},
    {"world", "start", "", FieldNeed::optional, "S, a region; --start goes first"},
    {"world", "goal", "", FieldNeed::optional, "G, a region; --goal goes first"},
    {"world", "obstacles", "", FieldNeed::required, "a list of regions, which may overlap"},
    {"bounds", "low", "m", FieldNeed::required, "the corner [x, y] of the least x and y"},
    {"bounds", "high", "m", FieldNeed::required, "the corner of the largest"},
    {"region", "disc", "", FieldNeed::optional, "either this, an object,"},
    {"region", "polygon", "m", FieldNeed::optional, "or this, a list of 3 points [x, y] or more"},
    {"disc", "x_m", "m", FieldNeed::required, "of its centre"},
    {"disc", "y_m", "m", FieldNeed::required, "the same"},
    {"disc", "radius_m", "m", FieldNeed::required, "above 0"},
});

}  // namespace

std::span<const FileField> world_fields() noexcept { return kWorldFields; }

}  // namespace tcert
