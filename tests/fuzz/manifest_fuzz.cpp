// Any bytes as a manifest.json: read or not, never a throw, twice the same; and what is wrong with
// it is said in one line.

#include <cstddef>
#include <cstdint>
#include <string>

#include "fuzz/check.hpp"
#include "fuzz/memory_file.hpp"
#include "reports/manifest_checks.hpp"
#include "reports/manifest_read.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcert;
  const fuzz::MemoryFile file(data, size);
  const auto manifest = read_manifest(file.path());
  fuzz::require(why_no_manifest(file.path()).find('\n') == std::string::npos, "one line");
  const auto again = read_manifest(file.path());
  fuzz::require(manifest.has_value() == again.has_value(), "twice the same");
  if (manifest) {
    fuzz::require(manifest->outputs.size() == again->outputs.size() &&
                      manifest->parameters == again->parameters,
                  "twice the same");
  }
  return 0;
}
