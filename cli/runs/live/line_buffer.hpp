#pragma once
/// \file
/// Bytes as they arrive in, whole lines out.

#include <cstddef>
#include <string>
#include <string_view>

namespace tcert::cli {

/// Hands out a line when its line feed has arrived. A line of more than 1 MiB is skipped and
/// counted, so that memory does not grow with what a producer sends.
class LineBuffer {
 public:
  void add(std::string_view bytes);

  /// What is left without a line feed is a line as well.
  void end();

  /// False if there is no whole line.
  [[nodiscard]] bool next(std::string& line);

  [[nodiscard]] std::size_t too_long() const noexcept { return too_long_; }

 private:
  std::string buffer_;
  std::size_t at_ = 0;
  std::size_t searched_ = 0;
  std::size_t too_long_ = 0;
  bool skipping_ = false;
};

}  // namespace tcert::cli
