// Any text as a submap: refused, or one that reads back the same, merges with itself to itself, and
// whose T_H is at least every source's own.

#include <cstddef>
#include <cstdint>
#include <federation/federate.hpp>
#include <federation/submap_text.hpp>
#include <stdexcept>
#include <string_view>

#include "fuzz/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcert::federation;
  const ReadSubmap read = read_submap(std::string_view(reinterpret_cast<const char*>(data), size));
  if (!read.submap) {
    tcert::fuzz::require(!read.problem.expected.empty(), "what is refused has a reason");
    return 0;
  }
  const std::string text = to_text(*read.submap);
  const ReadSubmap again = read_submap(text);
  tcert::fuzz::require(again.submap && to_text(*again.submap) == text,
                       "what is written reads back the same");
  tcert::fuzz::require(to_text(merge(*read.submap, *again.submap)) == text,
                       "a submap merged with itself is itself");
  try {
    const Federation found = federate(*read.submap);
    for (const double own : found.own) {
      tcert::fuzz::require(found.way.margin_m >= own, "T_H is at least every source's own");
    }
  } catch (const std::length_error&) {
    // More nodes near each other than it looks at.
  }
  return 0;
}
