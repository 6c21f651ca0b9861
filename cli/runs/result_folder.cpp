#include "cli/runs/result_folder.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <table/bytes.hpp>
#include <table/path_name.hpp>
#include <table/temporary_name.hpp>
#include <utility>

#include "cli/runs/errors.hpp"
#include "reports/manifest_checks.hpp"
#include "reports/manifest_read.hpp"

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, int error) {
  throw table::WriteError("cannot write '" + path.string() +
                          "': " + std::generic_category().message(error));
}

/// True if there is something to replace and it may be. \throws WriteError if it may not.
bool may_replace(const fs::path& folder, const std::string& command) {
  table::require_output_place(folder);
  std::error_code error;
  if (!fs::is_directory(folder, error) || fs::is_empty(folder, error)) {
    return false;
  }
  const auto refuse = [&](const std::string& reason) {
    throw table::WriteError("cannot replace the folder '" + folder.string() + "': " + reason +
                            "; name another folder or remove this one");
  };
  const auto written = read_manifest(folder / "manifest.json");
  if (!written) {
    refuse("it is not empty and was not written by this tool");
  } else if (written->command != command) {
    refuse("it holds results of 'tcert " + written->command + "'");
  } else if (const auto file = first_difference(folder, *written)) {
    refuse("'" + *file + "' was added or changed since it was written");
  }
  return true;
}

/// Opens it for writing; what it is called must not be a link. Empty, with errno, if it cannot be.
std::FILE* open_for_writing(const fs::path& path) {
  const int descriptor = ::open(
      path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
  std::FILE* const file = descriptor < 0 ? nullptr : ::fdopen(descriptor, "wb");
  if (file == nullptr && descriptor >= 0) {
    const int error = errno;
    ::close(descriptor);
    errno = error;
  }
  return file;
}

/// \throws WriteError unless `name` leads to a place within the folder that it is relative to.
void require_within(const fs::path& name) {
  if (!table::leads_below(name)) {
    throw table::WriteError("cannot write '" + name.string() +
                            "': it does not lie in the output folder");
  }
}

/// Makes the folders that `name` lies in within `folder`, but not `folder` itself: once an
/// interrupt has removed it nothing brings it back. \throws WriteError if one of them is a link.
void make_folders_within(const fs::path& folder, const fs::path& name) {
  fs::path place = folder;
  for (const fs::path& part : name.parent_path()) {
    place /= part;
    std::error_code error;
    if (fs::is_symlink(place, error)) {
      throw table::WriteError("cannot write '" + name.string() + "': '" + part.string() +
                              "' is a link");
    }
    fs::create_directory(place, error);
    if (error) {
      fail(place, error.value());
    }
  }
}

fs::path manifest_of(const fs::path& path) { return path.string() + ".manifest.json"; }

/// A manifest that lies beside a file, complete, whose process was killed before it got its name:
/// it gets it now if it is that of the file.
void finish_interrupted(const fs::path& path) {
  std::error_code error;
  const std::string wanted = table::name_in_temporary(manifest_of(path));
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_regular_file(path, error)) {
    return;
  }
  std::vector<fs::path> leftovers;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const auto temporary = table::swept_name_from(at->path().filename().native());
    if (temporary && temporary->name == wanted && table::is_forsaken(at->path(), *temporary)) {
      leftovers.push_back(at->path());
    }
  }
  for (const fs::path& leftover : leftovers) {
    const auto written = read_manifest(leftover);
    if (written && written->outputs.size() == 1 && written->outputs[0].path == name_of(path) &&
        written->outputs[0].digest.sha256 == digest_file(path).sha256) {
      fs::rename(leftover, manifest_of(path), error);
      return;
    }
  }
}

}  // namespace

ResultFile::ResultFile(fs::path path)
    : path_(std::move(path)), file_(open_for_writing(path_), std::fclose) {
  if (!file_) {
    fail(path_, errno);
  }
}

void ResultFile::write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) {
    fail(path_, errno);
  }
}

void ResultFile::flush() {
  if (std::fflush(file_.get()) != 0) {
    fail(path_, errno);
  }
}

void ResultFile::close() {
  if (std::fclose(file_.release()) != 0) {
    fail(path_, errno);
  }
}

ResultFolder::ResultFolder(const fs::path& path, std::string command)
    : path_((path / "").parent_path()),
      command_(std::move(command)),
      before_(state_of(path_)),
      folder_(path_, may_replace(path_, command_)) {}

void ResultFolder::write(const fs::path& name, std::string_view bytes) const {
  require_within(name);
  make_folders_within(staging(), name);
  ResultFile file(staging() / name);
  file.write(bytes);
  file.close();
}

void ResultFolder::commit(Manifest manifest) {
  manifest.outputs = folder_outputs(staging());
  write("manifest.json", to_json(manifest));
  const auto refuse = [&](const std::string& reason) {
    throw table::WriteError(reason +
                            "; that happened while this command ran, and its results are dropped");
  };
  FolderState now = state_of(path_);
  if (now != before_) {
    try {
      may_replace(path_, command_);
    } catch (const table::WriteError& error) {
      refuse(error.what());
    }
    now = state_of(path_);
  }
  folder_.commit([&](const fs::path& old) {
    if (state_of(old) != now) {
      refuse("cannot replace the folder '" + path_.string() +
             "': something in it was added or changed");
    }
  });
}

bool is_current(const fs::path& folder, Manifest expected) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    return false;
  }
  const table::BytesResult found = table::read_raw_file(folder / "manifest.json");
  if (!found.bytes || !strange_entries(folder).empty()) {
    return false;
  }
  expected.outputs = folder_outputs(folder);
  std::erase_if(expected.outputs,
                [](const ManifestFile& output) { return output.path == "manifest.json"; });
  return to_json(expected) == found.bytes->view();
}

void require_own_file(const fs::path& path) {
  if (path.empty()) {
    return;
  }
  table::require_output_place(path);
  table::require_output_place(manifest_of(path));
  finish_interrupted(path);
  table::sweep_leftovers(path);
  table::sweep_leftovers(manifest_of(path));
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    return;
  }
  const auto written = read_manifest(path.string() + ".manifest.json");
  if (!written || written->outputs.size() != 1 || written->outputs[0].path != name_of(path)) {
    throw table::WriteError("cannot replace '" + path.string() +
                            "': it was not written by this tool; name another file or remove it");
  }
  if (written->outputs[0].digest.sha256 != digest_file(path).sha256) {
    throw table::WriteError(
        "cannot replace '" + path.string() +
        "': it was changed since it was written; name another file or remove it");
  }
}

void require_own_folder(const fs::path& path, const std::string& command) {
  static_cast<void>(may_replace(path, command));
}

void remove_own_folder(const fs::path& path, const std::string& command) {
  const FolderState before = state_of(path);
  if (!may_replace(path, command)) {
    return;
  }
  // Out of everybody's way first, so that what is looked at is what is removed.
  const fs::path aside = table::temporary_name((path / "").parent_path(), table::Leftover::swept);
  std::error_code error;
  fs::rename(path, aside, error);
  if (error) {
    fail(path, error.value());
  }
  if (state_of(aside) != before) {
    const fs::path kept = table::temporary_name((path / "").parent_path(), table::Leftover::kept);
    fs::rename(aside, path, error);
    if (error) {
      fs::rename(aside, kept, error);
    }
    throw table::WriteError(
        "cannot remove the folder '" + path.string() +
        "': something in it was added or changed just now" +
        (fs::exists(kept, error) ? "; it is called '" + kept.string() + "' now" : ""));
  }
  fs::remove_all(aside, error);
  if (error) {
    fail(path, error.value());
  }
}

void remove_own_file(const fs::path& path) {
  require_own_file(path);
  for (const std::string& name : {path.string(), path.string() + ".manifest.json"}) {
    std::error_code error;
    fs::remove(name, error);
    if (error) {
      fail(name, error.value());
    }
  }
}

void write_with_manifest(const fs::path& path, std::string_view text, Manifest manifest) {
  table::AtomicFile file(path);
  file.write(text);
  file.sync();
  manifest.outputs = {{name_of(path), {1, text.size(), sha256(text)}}};
  table::AtomicFile beside(manifest_of(path));
  beside.write(to_json(manifest));
  beside.sync();
  require_own_file(path);
  // From here on an interrupt leaves the manifest to the next run, as a kill does.
  beside.keep_when_interrupted();
  file.commit();
  beside.commit();
}

void require_apart(const std::filesystem::path& input, const std::filesystem::path& output) {
  table::require_output_place(output);
  const auto from = std::filesystem::weakly_canonical(input);
  const auto to = std::filesystem::weakly_canonical(output);
  const auto [end, _] = std::mismatch(to.begin(), to.end(), from.begin(), from.end());
  if (end == to.end()) {
    throw UsageError("the output " + output.string() + " would replace the input " +
                     input.string() + "; name another folder");
  }
}

}  // namespace tcert::cli
