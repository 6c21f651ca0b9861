#include "cli/result_folder.hpp"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

#include "cli/output.hpp"

namespace tcert::cli {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw WriteError("cannot write '" + path.string() +
                   "': " + std::generic_category().message(error));
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

ResultFolder::ResultFolder(const std::filesystem::path& path) : folder_(path, may_replace(path)) {}

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
  if (!may_replace(folder)) {
    return false;
  }
  std::ifstream file(folder / "manifest.json", std::ios::binary);
  const std::string found{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  expected.outputs = folder_outputs(folder);
  std::erase_if(expected.outputs,
                [](const ManifestFile& output) { return output.path == "manifest.json"; });
  return to_json(expected) == found;
}

void write_with_manifest(const std::filesystem::path& path,
                         std::string_view text,
                         Manifest manifest) {
  write_file_atomically(path, text);
  manifest.outputs = {{name_of(path), digest_file(path)}};
  write_file_atomically(path.string() + ".manifest.json", to_json(manifest));
}

}  // namespace tcert::cli
