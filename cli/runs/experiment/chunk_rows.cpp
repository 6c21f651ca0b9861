#include "cli/runs/experiment/chunk_rows.hpp"

#include <algorithm>
#include <cstddef>

namespace tcert::cli {

std::string to_text(const ChunkRows& entry) {
  std::string text;
  for (const std::string& id : entry.rejected) {
    text += id + '\n';
  }
  return text + '\n' + entry.rows;
}

ChunkRows chunk_rows_from(const std::string& text) {
  ChunkRows entry;
  std::size_t at = 0;
  for (std::size_t end = text.find('\n', at); end != std::string::npos && end > at;
       end = text.find('\n', at)) {
    entry.rejected.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  entry.rows = text.substr(std::min(at + 1, text.size()));
  return entry;
}

}  // namespace tcert::cli
