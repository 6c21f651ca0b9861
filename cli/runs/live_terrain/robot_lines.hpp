#pragma once
/// \file
/// The two ends of a robot that sends lines and reads rows: stdin and stdout, or a connection.

#include <optional>
#include <string>

#include "cli/runs/live/line_buffer.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/unix_listener.hpp"

namespace tcert::cli {

class RobotLines {
 public:
  /// Waits for who connects, if there is something to listen on ("unix:PATH"), and says on what.
  /// \throws UsageError, NoInput.
  RobotLines(const std::string& listen, Progress& progress);

  /// The next line, waited for; none at the end or when the process is told to end.
  [[nodiscard]] std::optional<std::string> next();

  /// To the robot, whole and at once; of a connection also to stdout. False if nobody reads.
  /// \throws WriteError.
  [[nodiscard]] bool answer(const std::string& row);
  /// A line "# text" to who is connected; nothing without a connection. Returns and throws
  /// likewise.
  [[nodiscard]] bool remark(const std::string& text);

  [[nodiscard]] bool is_connected() const noexcept { return connection_.get() >= 0; }
  [[nodiscard]] std::size_t too_long() const noexcept { return lines_.too_long(); }

 private:
  Descriptor connection_;
  int interrupt_;
  LineBuffer lines_;
  bool ended_ = false;
};

}  // namespace tcert::cli
