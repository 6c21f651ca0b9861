#include "cli/runs/scratch_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>
#include <table/atomic_file.hpp>
#include <table/temporary_name.hpp>

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

/// TMPDIR, or /tmp.
fs::path place() {
  std::error_code error;
  const fs::path folder = fs::temp_directory_path(error);
  if (error) {
    const char* const variable = std::getenv("TMPDIR");
    throw table::WriteError("cannot make a scratch folder in '" +
                            std::string(variable != nullptr ? variable : "/tmp") +
                            "': " + error.message() + "; TMPDIR must name a folder");
  }
  return folder / "tcert";
}

}  // namespace

ScratchFolder::ScratchFolder() {
  const fs::path beside = place();
  table::sweep_leftovers(beside);
  for (bool made = false; !made;) {
    path_ = table::temporary_name(beside, table::Leftover::swept);
    table::remove_when_interrupted(path_);
    made = ::mkdir(path_.c_str(), 0700) == 0;
    if (const int error = errno; !made) {
      table::forget_interrupted(path_);
      if (error != EEXIST) {
        throw table::WriteError("cannot make a scratch folder '" + path_.string() +
                                "': " + std::generic_category().message(error));
      }
    }
  }
  lock_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ >= 0) {
    ::flock(lock_, LOCK_SH | LOCK_NB);
  }
}

ScratchFolder::~ScratchFolder() {
  if (lock_ >= 0) {
    ::close(lock_);  // Where descriptors are short, removing needs it.
  }
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  table::forget_interrupted(path_);
}

}  // namespace tcert::cli
