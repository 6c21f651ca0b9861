#pragma once
/// \file
/// Every key of a world file of our own format.

#include <span>

#include "datasets/file_field.hpp"

namespace tcert {

/// The places are "world", and its objects "bounds", "region" and "disc".
[[nodiscard]] std::span<const FileField> world_fields() noexcept;

}  // namespace tcert
