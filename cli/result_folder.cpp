#include "cli/result_folder.hpp"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

#include "cli/output.hpp"
#include "reports/manifest_read.hpp"

namespace tcert::cli {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw WriteError("cannot write '" + path.string() +
                   "': " + std::generic_category().message(error));
}

/// True if there is something to replace and it may be. \throws WriteError if it may not.
bool may_replace(const std::filesystem::path& folder, const std::string& command) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error) || std::filesystem::is_empty(folder, error)) {
    return false;
  }
  const auto refuse = [&](const std::string& reason) {
    throw WriteError("cannot replace the folder '" + folder.string() + "': " + reason +
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

}  // namespace

ResultFile::ResultFile(std::filesystem::path path)
    : path_(std::move(path)), file_(std::fopen(path_.c_str(), "wb"), std::fclose) {
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

ResultFolder::ResultFolder(const std::filesystem::path& path, const std::string& command)
    : folder_(path, may_replace(path, command)) {}

void ResultFolder::write(const std::filesystem::path& name, std::string_view bytes) const {
  const std::filesystem::path path = staging() / name;
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  if (error) {
    fail(path.parent_path(), error.value());
  }
  ResultFile file(path);
  file.write(bytes);
  file.close();
}

void ResultFolder::commit(Manifest manifest) {
  manifest.outputs = folder_outputs(staging());
  write("manifest.json", to_json(manifest));
  folder_.commit();
}

bool is_current(const std::filesystem::path& folder, Manifest expected) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) {
    return false;
  }
  std::ifstream file(folder / "manifest.json", std::ios::binary);
  const std::string found{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  expected.outputs = folder_outputs(folder);
  std::erase_if(expected.outputs,
                [](const ManifestFile& output) { return output.path == "manifest.json"; });
  return to_json(expected) == found;
}

void require_own_file(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    return;
  }
  const auto written = read_manifest(path.string() + ".manifest.json");
  if (!written || written->outputs.size() != 1 || written->outputs[0].path != name_of(path)) {
    throw WriteError("cannot replace '" + path.string() +
                     "': it was not written by this tool; name another file or remove it");
  }
  if (written->outputs[0].digest.sha256 != digest_file(path).sha256) {
    throw WriteError("cannot replace '" + path.string() +
                     "': it was changed since it was written; name another file or remove it");
  }
}

void remove_own_folder(const std::filesystem::path& path, const std::string& command) {
  std::error_code error;
  if (may_replace(path, command)) {
    std::filesystem::remove_all(path, error);
  }
  if (error) {
    fail(path, error.value());
  }
}

void remove_own_file(const std::filesystem::path& path) {
  require_own_file(path);
  for (const std::string& name : {path.string(), path.string() + ".manifest.json"}) {
    std::error_code error;
    std::filesystem::remove(name, error);
    if (error) {
      fail(name, error.value());
    }
  }
}

void write_with_manifest(const std::filesystem::path& path,
                         std::string_view text,
                         Manifest manifest) {
  require_own_file(path);
  write_file_atomically(path, text);
  manifest.outputs = {{name_of(path), digest_file(path)}};
  write_file_atomically(path.string() + ".manifest.json", to_json(manifest));
}

}  // namespace tcert::cli
