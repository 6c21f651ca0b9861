#include "datasets/import/file_window.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <table/regular_file.hpp>
#include <utility>

namespace tcert::recording {
namespace {

constexpr std::size_t kLeastPiece = std::size_t{256} << 10U;

}  // namespace

std::span<std::byte> Buffer::room(std::size_t size, std::size_t kept) {
  if (size > capacity_) {
    try {
      // NOLINTNEXTLINE(modernize-avoid-c-arrays)
      auto larger = std::make_unique_for_overwrite<std::byte[]>(size);
      if (kept > 0) {
        std::memcpy(larger.get(), data_.get(), std::min(kept, capacity_));
      }
      data_ = std::move(larger);
    } catch (const std::bad_alloc&) {
      throw table::OutOfResources("there is not enough memory for a part of " +
                                  std::to_string(size) + " bytes of a recording");
    }
    capacity_ = size;
  }
  return {data_.get(), size};
}

void Buffer::release() noexcept {
  data_.reset();
  capacity_ = 0;
}

std::optional<FileWindow> FileWindow::open(const std::filesystem::path& path,
                                           std::string& problem) {
  const int descriptor = table::open_regular_file(path, problem);
  if (descriptor < 0) {
    return std::nullopt;
  }
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) {
    problem = "its length cannot be told";
    ::close(descriptor);
    return std::nullopt;
  }
  return FileWindow(descriptor, static_cast<std::uint64_t>(status.st_size));
}

FileWindow::FileWindow(int descriptor, std::uint64_t size) noexcept
    : descriptor_(descriptor), size_(size) {}

FileWindow::FileWindow(FileWindow&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_),
      buffer_(std::move(other.buffer_)),
      held_(std::exchange(other.held_, {})),
      begin_(other.begin_) {}

FileWindow::~FileWindow() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

std::size_t FileWindow::read(std::uint64_t offset, std::span<std::byte> to) const noexcept {
  std::size_t done = 0;
  while (done < to.size()) {
    const ssize_t taken =
        ::pread(descriptor_, to.data() + done, to.size() - done, static_cast<off_t>(offset + done));
    if (taken < 0 && errno == EINTR) {
      continue;
    }
    if (taken <= 0) {
      break;
    }
    done += static_cast<std::size_t>(taken);
  }
  return done;
}

std::span<const std::byte> FileWindow::at(std::uint64_t offset, std::size_t length) {
  if (offset >= size_) {
    return {};
  }
  length = static_cast<std::size_t>(std::min<std::uint64_t>(length, size_ - offset));
  const bool begins_inside = offset >= begin_ && offset - begin_ <= held_.size();
  const auto skipped = begins_inside ? static_cast<std::size_t>(offset - begin_) : 0;
  if (begins_inside && length <= held_.size() - skipped) {
    return held_.subspan(skipped, length);
  }
  // What is held of it moves to the front, and the rest is read behind it.
  const std::size_t kept = begins_inside ? held_.size() - skipped : 0;
  const auto piece = static_cast<std::size_t>(
      std::min<std::uint64_t>(std::max(length, kLeastPiece), size_ - offset));
  if (kept > 0) {
    std::memmove(held_.data(), held_.data() + skipped, kept);
  }
  const std::span<std::byte> all = buffer_.room(piece, kept);
  const std::size_t added = piece > kept ? read(offset + kept, all.subspan(kept)) : 0;
  held_ = all.first(kept + added);
  begin_ = offset;
  return held_.first(std::min(length, held_.size()));
}

void FileWindow::release() noexcept {
  buffer_.release();
  held_ = {};
  begin_ = 0;
}

}  // namespace tcert::recording
