// Any bytes as a table of any columns, as features, certificates and other results are read back:
// never a throw, no table without a reason, and columns that are as long as one another.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <table/read_data_table.hpp>

#include "fuzz/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcert;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  table::CsvOptions csv;
  csv.file = "fuzz.csv";
  const auto result = table::read_data_table(table::Bytes::copy_of(text), {}, csv);
  fuzz::require(result.table.has_value() != table::has_error(result.diagnostics),
                "no table without a reason");
  for (const table::Diagnostic& diagnostic : result.diagnostics) {
    fuzz::require(table::to_string(diagnostic).find('\n') == std::string::npos,
                  "a message is one line");
  }
  return 0;
}
