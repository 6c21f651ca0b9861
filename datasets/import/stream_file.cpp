#include "datasets/import/stream_file.hpp"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <table/atomic_file.hpp>
#include <table/csv_write.hpp>
#include <utility>

namespace tcert::recording {
namespace {

constexpr std::size_t kHeldBytes = std::size_t{1} << 16U;

}  // namespace

StreamFile::StreamFile(std::filesystem::path path, const std::vector<std::string>& columns)
    : path_(std::move(path)) {
  std::error_code error;
  std::filesystem::create_directories(path_.parent_path(), error);
  if (error) {
    throw table::WriteError("cannot make the folder of '" + path_.string() +
                            "': " + error.message());
  }
  text_ = "time_s";
  for (const std::string& column : columns) {
    text_ += ',' + column;
  }
  text_ += '\n';
}

void StreamFile::add(std::int64_t time_ns, std::span<const double> values) {
  table::append_seconds(text_, time_ns);
  for (const double value : values) {
    table::append_cell(text_, value);
  }
  text_ += '\n';
  if (text_.size() > kHeldBytes) {
    flush();
  }
}

void StreamFile::flush() {
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path_.c_str(), "abe"),
                                                       std::fclose);
  const bool written =
      file && std::fwrite(text_.data(), 1, text_.size(), file.get()) == text_.size();
  if (!written || std::fclose(file.release()) != 0) {
    throw table::WriteError("cannot write '" + path_.string() +
                            "': " + std::generic_category().message(errno));
  }
  text_.clear();
}

}  // namespace tcert::recording
