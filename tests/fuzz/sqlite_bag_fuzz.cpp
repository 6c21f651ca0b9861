// Any bytes as the database of a rosbag2: as mcap_fuzz; and no file appears beside it.

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "datasets/import/sqlite_bag.hpp"
#include "fuzz/read_bag.hpp"

namespace {

/// A folder that goes with the process.
struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("tcert_fuzz_" + std::to_string(::getpid()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcert;
  static const Folder folder;
  const std::filesystem::path path = folder.path / "bag.db3";
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  table::DiagnosticGroups problems;
  {
    const auto bag = recording::open_sqlite_bag(path, problems);
    fuzz::require((bag == nullptr) == problems.has_error(), "no bag iff there is an error");
    if (bag) {
      fuzz::read_twice(*bag, problems);
    }
  }
  fuzz::require_lines(problems);
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path)) {
    ++files;
  }
  fuzz::require(files == 1, "nothing is written beside the database");
  return 0;
}
