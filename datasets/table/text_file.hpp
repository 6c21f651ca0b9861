#pragma once
/// \file
/// Text files as other programs write them: UTF-16, and carriage returns alone as line ends.

#include <filesystem>
#include <table/bytes.hpp>

namespace tcert::table {

/// UTF-16 with a byte-order mark as UTF-8, a lone half of a pair as U+FFFD; carriage returns as
/// line feeds where there is no line feed at all. All other bytes as they are. O(size).
[[nodiscard]] Bytes as_text(Bytes bytes);

/// read_file(), as text. \throws OutOfResources.
[[nodiscard]] BytesResult read_text_file(const std::filesystem::path& path);

}  // namespace tcert::table
