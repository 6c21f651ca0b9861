#pragma once
/// \file
/// What is read and what is not: regular files of a size that a log may have.

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace tcert::table {

/// The system has too little of something: descriptors, memory. No fault of what is read, so it
/// ends the run instead of rejecting a trial. Exit code 71.
class OutOfResources : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Opens a regular file for reading; the descriptor is the caller's. What is none (a pipe, a
/// socket, a device, a folder) is not waited for: -1, with the reason in `problem` and errno.
/// \throws OutOfResources if there is no descriptor left.
[[nodiscard]] int open_regular_file(const std::filesystem::path& path, std::string& problem);

/// \throws OutOfResources naming the file if `error` says that there is too little of something.
void require_resources(const std::filesystem::path& path, int error);

/// True unless contents of `size` bytes that come from `packed` bytes are those of a file made to
/// fill the memory: more than 64 MiB, and 200 times as long as the file, as no log is.
[[nodiscard]] bool is_plausible_expansion(std::size_t packed, std::size_t size) noexcept;

}  // namespace tcert::table
