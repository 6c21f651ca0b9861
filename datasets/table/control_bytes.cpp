#include <table/control_bytes.hpp>

#include <cstddef>

namespace tcert::table {

void find_control_bytes(std::string_view text,
                        const std::string& file,
                        DiagnosticGroups& problems) {
  std::size_t line = 1;
  std::size_t first_line = 0;
  std::size_t count = 0;
  unsigned first = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    line += c == '\n' ? 1U : 0U;
    if ((byte < 0x20U && c != '\n' && c != '\r' && c != '\t') || byte == 0x7FU) {
      first_line = count == 0 ? line : first_line;
      first = count == 0 ? byte : first;
      ++count;
    }
  }
  if (count > 0) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    const std::string code{kDigits[first / 16U], kDigits[first % 16U]};
    problems.add({Severity::error,
                  file,
                  first_line,
                  "",
                  count == 1 ? "a control byte 0x" + code
                             : std::to_string(count) + " control bytes, the first 0x" + code,
                  "text alone",
                  1});
  }
}

}  // namespace tcert::table
