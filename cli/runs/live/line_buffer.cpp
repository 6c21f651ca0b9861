#include "cli/runs/live/line_buffer.hpp"

#include <algorithm>

namespace tcert::cli {
namespace {

constexpr std::size_t kLongestLine = std::size_t{1} << 20U;

}  // namespace

void LineBuffer::add(std::string_view bytes) {
  if (skipping_) {
    const auto feed = bytes.find('\n');
    skipping_ = feed == std::string_view::npos;
    bytes.remove_prefix(skipping_ ? bytes.size() : feed + 1);
  }
  buffer_.erase(0, at_);
  searched_ -= std::min(searched_, at_);
  at_ = 0;
  buffer_.append(bytes);
}

void LineBuffer::end() {
  if (at_ < buffer_.size()) {
    buffer_ += '\n';
  }
  skipping_ = false;
}

bool LineBuffer::next(std::string& line) {
  for (;;) {
    const auto feed = buffer_.find('\n', std::max(searched_, at_));
    const std::size_t length = std::min(feed, buffer_.size()) - at_;
    const bool is_long = length > kLongestLine;
    too_long_ += is_long ? 1 : 0;
    if (feed == std::string::npos) {
      searched_ = buffer_.size();
      if (is_long) {
        buffer_.clear();
        at_ = searched_ = 0;
        skipping_ = true;
      }
      return false;
    }
    if (!is_long) {
      line.assign(buffer_, at_, length);
    }
    at_ = searched_ = feed + 1;
    if (!is_long) {
      return true;
    }
  }
}

}  // namespace tcert::cli
