#pragma once
/// \file
/// The keys of a map, each declared once.

#include <span>

#include "datasets/file_field.hpp"

namespace tcert::recording {

/// Place "map" is the whole, all others are objects in it.
[[nodiscard]] std::span<const FileField> map_fields() noexcept;

}  // namespace tcert::recording
