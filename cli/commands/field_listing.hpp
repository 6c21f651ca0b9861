#pragma once
/// \file
/// The columns and keys of a file format, as help shows them.

#include <span>
#include <string>

#include "datasets/file_field.hpp"
#include "reports/table.hpp"

namespace tcert::cli {

/// A line each, indented: what the file as a whole holds, then each object, "disc.x_m".
[[nodiscard]] std::string fields_in_words(std::span<const FileField> fields);

/// The files of a log bundle, their columns and keys, and below them what is said of all.
[[nodiscard]] Table bundle_listing();

/// `help map`: every key of the map of `import log`.
[[nodiscard]] Table map_listing();

}  // namespace tcert::cli
