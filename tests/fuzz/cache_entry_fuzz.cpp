// Any bytes as an entry of the cache: rejected trials without line feeds, and rows; what is
// written of it reads back the same.

#include <cstddef>
#include <cstdint>
#include <string>

#include "cli/runs/experiment/chunk_rows.hpp"
#include "fuzz/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcert;
  const auto entry = cli::chunk_rows_from({reinterpret_cast<const char*>(data), size});
  for (const std::string& id : entry.rejected) {
    fuzz::require(!id.empty() && id.find('\n') == std::string::npos, "an id is a line");
  }
  const auto again = cli::chunk_rows_from(cli::to_text(entry));
  fuzz::require(again.rejected == entry.rejected && again.rows == entry.rows,
                "what is written reads back the same");
  return 0;
}
