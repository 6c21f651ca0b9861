#include "cli/line_source.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "cli/errors.hpp"

namespace tcert::cli {
namespace {

constexpr std::size_t kLongestLine = std::size_t{1} << 20U;

}  // namespace

bool LineSource::next(std::string& line) {
  std::size_t searched = at_;
  for (;;) {
    const auto feed = buffer_.find('\n', searched);
    if (feed != std::string::npos) {
      line.assign(buffer_, at_, feed - at_);
      at_ = feed + 1;
      return true;
    }
    if (ended_) {
      line.assign(buffer_, at_);
      at_ = buffer_.size();
      return !line.empty();
    }
    if (buffer_.size() - at_ > kLongestLine) {
      throw BadData("stdin: a line of more than 1 MiB");
    }
    buffer_.erase(0, at_);
    at_ = 0;
    searched = buffer_.size();
    std::array<char, 65536> chunk{};
    const ssize_t got = ::read(STDIN_FILENO, chunk.data(), chunk.size());
    if (got > 0) {
      buffer_.append(chunk.data(), static_cast<std::size_t>(got));
    } else if (got == 0) {
      ended_ = true;
    } else if (errno != EINTR) {
      throw BadData("stdin: " + std::generic_category().message(errno));
    }
  }
}

}  // namespace tcert::cli
