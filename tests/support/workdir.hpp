#pragma once
/// \file
/// Runs a program in a fresh directory and keeps what it printed.

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tcert::test_support {

struct ProcessResult {
  std::string command;
  int exit_code = -1;  ///< 128 + signal if it was killed.
  std::string out;
  std::string err;
};

/// For failure messages: command, exit code, stdout, stderr.
[[nodiscard]] std::string to_string(const ProcessResult& run);

/// A directory of its own, removed afterwards.
class Workdir {
 public:
  explicit Workdir(std::string program);
  ~Workdir();
  Workdir(const Workdir&) = delete;
  Workdir& operator=(const Workdir&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  [[nodiscard]] std::filesystem::path operator/(std::string_view name) const {
    return path_ / name;
  }

  /// Runs the program here with `input` on stdin and waits for it.
  ProcessResult run(const std::vector<std::string>& arguments, std::string_view input = {});

  /// Starts it without waiting; the caller kills it and waits.
  [[nodiscard]] pid_t start(const std::vector<std::string>& arguments);

  void write(std::string_view name, std::string_view text) const;
  [[nodiscard]] std::string read(std::string_view name) const;

  /// Every regular file under `name`, by its path relative to it, in byte order.
  [[nodiscard]] std::vector<std::string> files(std::string_view name) const;

 private:
  std::string program_;
  std::filesystem::path path_;
};

}  // namespace tcert::test_support
