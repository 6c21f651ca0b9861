#pragma once
/// \file
/// Lines of stdin as soon as they are there.

#include <string>

namespace tcert::cli {

/// Hands out a line when its line feed has arrived, not when a buffer is full.
class LineSource {
 public:
  /// False at the end of the input. A last line without a line feed counts. \throws BadData if
  /// stdin cannot be read, or a line is longer than 1 MiB.
  [[nodiscard]] bool next(std::string& line);

 private:
  std::string buffer_;
  std::size_t at_ = 0;
  bool ended_ = false;
};

}  // namespace tcert::cli
