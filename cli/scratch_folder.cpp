#include "cli/scratch_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

#include "datasets/atomic_file.hpp"

namespace tcert::cli {

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "tcert-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw WriteError("cannot make a scratch folder '" + name +
                     "': " + std::generic_category().message(errno));
  }
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace tcert::cli
