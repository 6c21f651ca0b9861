// Any text as a formula: refused, or parsed into terms whose columns have names.

#include <cstddef>
#include <cstdint>
#include <statistics/model/formula.hpp>
#include <string>
#include <string_view>

#include "fuzz/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcert;
  try {
    const auto formula = statistics::parse_formula({reinterpret_cast<const char*>(data), size});
    for (const std::string& column : formula.columns()) {
      fuzz::require(!column.empty(), "a column has a name");
    }
    for (const auto& term : formula.terms) {
      fuzz::require(!term.name().empty(), "a term has a name");
    }
  } catch (const statistics::FormulaError& error) {
    fuzz::require(std::string_view(error.what()).find('\n') == std::string_view::npos,
                  "a message is one line");
  }
  return 0;
}
