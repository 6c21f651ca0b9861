// Any bytes as a bundle.json: never a throw, and a description that is accepted is written and read
// back as the same.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "datasets/bundle_json.hpp"
#include "fuzz/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcert;
  table::DiagnosticGroups problems;
  const auto info = parse_bundle_json({reinterpret_cast<const char*>(data), size}, problems);
  fuzz::require(info.has_value() != problems.has_error(), "rejected iff there is an error");
  for (const table::Diagnostic& diagnostic : problems.take()) {
    fuzz::require(table::to_string(diagnostic).find('\n') == std::string::npos,
                  "a message is one line");
  }
  if (info) {
    const std::string text = to_bundle_json(*info);
    const auto again = parse_bundle_json(text, problems);
    fuzz::require(again.has_value(), "what is written is accepted");
    fuzz::require(to_bundle_json(*again) == text, "what is written reads back the same");
  }
  return 0;
}
