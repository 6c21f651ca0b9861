// Any bytes as a witness: refused, or a document that is written as it was read.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/check.hpp"
#include "reports/witness_json.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcert;
  constexpr std::size_t kMostCells = 1U << 20U;
  try {
    const WitnessDocument proof =
        witness_from_json({reinterpret_cast<const char*>(data), size}, kMostCells);
    const std::string text = to_json(proof);
    fuzz::require(to_json(witness_from_json(text, kMostCells)) == text,
                  "what is written reads back the same");
  } catch (const WitnessFormatError&) {
    // Most bytes are none.
  }
  return 0;
}
