#include "datasets/bundle_files.hpp"

#include <sys/stat.h>
#include <zip.h>

#include <algorithm>
#include <cerrno>
#include <string_view>
#include <system_error>
#include <table/regular_file.hpp>
#include <table/text_file.hpp>
#include <utility>

namespace tcert {

namespace {

constexpr std::string_view kDescription = "bundle.json";

std::string zip_message(int code) {
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  std::string message = zip_error_strerror(&error);
  zip_error_fini(&error);
  return message;
}

void discard(zip_t* archive) noexcept {
  if (archive != nullptr) {
    zip_discard(archive);
  }
}

/// The folder of the bundle.json that lies least deep; empty if there is none or it is at the top.
std::string common_prefix(zip_t* archive) {
  std::optional<std::string> prefix;
  const zip_int64_t entries = zip_get_num_entries(archive, 0);
  for (zip_int64_t i = 0; i < entries; ++i) {
    const char* raw = zip_get_name(archive, static_cast<zip_uint64_t>(i), 0);
    const std::string_view name = raw == nullptr ? std::string_view{} : raw;
    if (!name.ends_with(kDescription)) {
      continue;
    }
    const std::string_view folder = name.substr(0, name.size() - kDescription.size());
    if ((folder.empty() || folder.back() == '/') && (!prefix || folder.size() < prefix->size())) {
      prefix = folder;
    }
  }
  return prefix.value_or("");
}

/// The archive that a thread opened last. A study reads one trial after the other out of the same
/// archive, and to read the list of a large one takes longer than the trial.
struct LastArchive {
  struct stat file {};
  std::shared_ptr<zip_t> archive;
  std::string prefix;

  /// True if it is the file of that state.
  [[nodiscard]] bool is(const struct stat& now) const noexcept {
    return archive && now.st_dev == file.st_dev && now.st_ino == file.st_ino &&
           now.st_size == file.st_size && now.st_mtim.tv_sec == file.st_mtim.tv_sec &&
           now.st_mtim.tv_nsec == file.st_mtim.tv_nsec;
  }
};

LastArchive& last_archive() {
  thread_local LastArchive last;
  return last;
}

}  // namespace

BundleFiles::BundleFiles(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path_, error);
  if (!std::filesystem::exists(status)) {
    problem_ = error ? error.message() : std::generic_category().message(ENOENT);
    return;
  }
  if (std::filesystem::is_directory(status)) {
    return;
  }
  if (!std::filesystem::is_regular_file(status)) {
    problem_ = "it is a pipe, a socket or a device, not a file";
    return;
  }
  LastArchive& last = last_archive();
  struct stat now {};
  const bool is_known = ::stat(path_.c_str(), &now) == 0;
  if (is_known && last.is(now)) {
    archive_ = last.archive;
    prefix_ = last.prefix;
    return;
  }
  last = {};
  int code = 0;
  errno = 0;
  archive_ = std::shared_ptr<zip_t>(zip_open(path_.c_str(), ZIP_RDONLY, &code), discard);
  if (!archive_) {
    table::require_resources(path_, errno);
  }
  if (archive_) {
    prefix_ = common_prefix(archive_.get());
    last = {now, is_known ? archive_ : nullptr, prefix_};
  } else if (path_.filename() == kDescription) {
    problem_ = "a file of a bundle; name the folder that it is in";
  } else {
    problem_ = zip_message(code);
  }
}

BundleFiles::~BundleFiles() = default;

bool BundleFiles::contains(const std::string& name) const {
  if (archive_) {
    return zip_name_locate(archive_.get(), (prefix_ + name).c_str(), 0) >= 0;
  }
  std::error_code ignored;
  return std::filesystem::is_regular_file(path_ / name, ignored);
}

std::optional<std::string> BundleFiles::find(const std::string& name) const {
  for (const char* ending : {"", ".gz", ".zst"}) {
    if (std::string candidate = name + ending; contains(candidate)) {
      return candidate;
    }
  }
  return std::nullopt;
}

table::BytesResult BundleFiles::read_from_archive(const std::string& name) const {
  const std::string full_name = prefix_ + name;
  zip_stat_t status;
  zip_stat_init(&status);
  if (zip_stat(archive_.get(), full_name.c_str(), 0, &status) != 0) {
    return {std::nullopt, zip_strerror(archive_.get())};
  }
  constexpr zip_uint64_t kLongestFile = zip_uint64_t{4} << 30U;
  if (status.size > kLongestFile) {
    return {std::nullopt, "its contents are longer than 4 GiB"};
  }
  if (!table::is_plausible_expansion(status.comp_size, status.size)) {
    return {std::nullopt, "its contents are more than 200 times as long as in the .zip"};
  }
  zip_file_t* file = zip_fopen_index(archive_.get(), status.index, 0);
  if (file == nullptr) {
    return {std::nullopt, zip_strerror(archive_.get())};
  }
  table::Bytes bytes(status.size);
  const zip_int64_t taken = zip_fread(file, bytes.data(), status.size);
  const int code = zip_fclose(file);
  if (taken < 0 || static_cast<zip_uint64_t>(taken) != status.size || code != 0) {
    return {std::nullopt, "the zip data are damaged"};
  }
  return {std::move(bytes), {}};
}

std::vector<std::string> BundleFiles::names() {
  namespace fs = std::filesystem;
  constexpr int kDeepest = 32;
  std::vector<std::string> names;
  if (archive_) {
    const zip_int64_t entries = zip_get_num_entries(archive_.get(), 0);
    for (zip_int64_t i = 0; i < entries; ++i) {
      const char* raw = zip_get_name(archive_.get(), static_cast<zip_uint64_t>(i), 0);
      const std::string_view name = raw == nullptr ? std::string_view{} : raw;
      if (name.starts_with(prefix_) && name.size() > prefix_.size() && name.back() != '/') {
        names.emplace_back(name.substr(prefix_.size()));
      }
    }
  } else {
    std::error_code error;
    const auto follow = fs::directory_options::follow_directory_symlink;
    fs::recursive_directory_iterator at(path_, follow, error);
    for (; !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
      if (at.depth() > kDeepest) {
        problem_ = "its folders are nested more than 32 levels deep";
        return {};
      }
      std::error_code ignored;
      if (fs::is_regular_file(at->path(), ignored)) {
        names.push_back(at->path().lexically_relative(path_).generic_string());
      }
    }
    problem_ = error ? error.message() : "";
  }
  std::ranges::sort(names);
  return names;
}

table::BytesResult BundleFiles::read_raw(const std::string& name) const {
  return archive_ ? read_from_archive(name) : table::read_raw_file(path_ / name);
}

table::BytesResult BundleFiles::read(const std::string& name) const {
  if (!archive_) {
    return table::read_text_file(path_ / name);
  }
  table::BytesResult result = read_from_archive(name);
  if (!result.bytes) {
    return result;
  }
  const table::Compression compression = table::compression_of(result.bytes->view());
  result = table::decompress(std::move(*result.bytes), compression);
  if (result.bytes) {
    result.bytes = table::as_text(std::move(*result.bytes));
  }
  return result;
}

}  // namespace tcert
