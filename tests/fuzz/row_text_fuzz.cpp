// Any line as a row of values: refused, or read so that what is written of it reads back the same.

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <table/row_text.hpp>

#include "fuzz/check.hpp"

namespace {

using tcert::table::Is;

struct Part {
  double number = 0.0;
  std::uint32_t count = 0;
  bool is_set = false;
};

void row_cells(auto& row, Is<Part> auto& part) { row(part.number, part.count, part.is_set); }

struct Whole {
  std::optional<Part> first;
  std::vector<Part> parts;
  std::vector<std::optional<double>> numbers;
};

void row_cells(auto& row, Is<Whole> auto& whole) { row(whole.first, whole.parts, whole.numbers); }

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const std::string written = tcert::table::row_text(tcert::table::from_row<Whole>(text));
    tcert::fuzz::require(tcert::table::row_text(tcert::table::from_row<Whole>(written)) == written,
                         "what is written of a row reads back the same");
  } catch (const tcert::table::RowError&) {
    // Most lines are none.
  }
  return 0;
}
