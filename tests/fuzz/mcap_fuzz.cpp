// Any bytes as an MCAP file: a bag or an error; never a throw; every message is decoded or says why
// not; a second pass shows the same.

#include <cstddef>
#include <cstdint>

#include "fuzz/memory_file.hpp"
#include "fuzz/read_bag.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcert;
  const fuzz::MemoryFile file(data, size);
  table::DiagnosticGroups problems;
  const auto bag = recording::open_mcap(file.path(), problems);
  fuzz::require((bag == nullptr) == problems.has_error(), "no bag iff there is an error");
  if (bag) {
    fuzz::read_twice(*bag, problems);
  }
  fuzz::require_lines(problems);
  return 0;
}
