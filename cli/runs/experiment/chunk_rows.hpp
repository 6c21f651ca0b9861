#pragma once
/// \file
/// What the cache keeps of a table: the rows of a chunk of trials.

#include <string>
#include <vector>

namespace tcert::cli {

/// Rows of one job for one chunk. As text: its rejected trials, whose ids hold no line feed
/// (is_file_name), an empty line, its rows of CSV.
struct ChunkRows {
  std::vector<std::string> rejected;
  std::string rows;
};

[[nodiscard]] std::string to_text(const ChunkRows& entry);
[[nodiscard]] ChunkRows chunk_rows_from(const std::string& text);

}  // namespace tcert::cli
