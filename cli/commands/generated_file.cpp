#include "cli/commands/generated_file.hpp"

#include <string>
#include <system_error>
#include <table/atomic_file.hpp>
#include <table/bytes.hpp>

namespace tcert::cli {

void write_generated(const std::filesystem::path& path,
                     std::string_view text,
                     std::string_view mark) {
  table::require_output_place(path);
  std::error_code error;
  if (std::filesystem::exists(path, error)) {
    const table::BytesResult old = table::read_raw_file(path);
    constexpr std::size_t kBeginning = 256;
    if (!old.bytes ||
        old.bytes->view().substr(0, kBeginning).find(mark) == std::string_view::npos) {
      throw table::WriteError("'" + path.string() +
                              "' is there and was not made by this command; it is left as it is");
    }
  }
  table::write_file_atomically(path, text);
}

}  // namespace tcert::cli
