#include "support/shell.hpp"

#include <filesystem>
#include <system_error>

#include "support/temporary_folder.hpp"

namespace tcert::test_support {

std::map<std::string, std::string> Shell::contents(const std::string& name,
                                                   const std::string& except) const {
  namespace fs = std::filesystem;
  std::map<std::string, std::string> found;
  const fs::path root = work_ / name;
  std::error_code error;
  for (fs::recursive_directory_iterator at(root, error), end; !error && at != end;
       at.increment(error)) {
    const std::string path = at->path().lexically_relative(root).generic_string();
    const bool is_ours = path == ".stdin" || path == ".stdout" || path == ".stderr";
    if (is_ours || (!except.empty() && (path == except || path.starts_with(except + "/")))) {
      continue;
    }
    found[path] = at->is_symlink()        ? "-> " + fs::read_symlink(at->path()).string()
                  : at->is_regular_file() ? read_text(at->path())
                  : at->is_directory()    ? "folder"
                                          : "special";
  }
  return found;
}

}  // namespace tcert::test_support
