#include "cli/runs/live/live_audit.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <table/atomic_file.hpp>
#include <utility>

#include "reports/audit.hpp"

namespace tcert::cli {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
  throw table::WriteError("cannot write the audit log '" + path + "': " + reason);
}

std::string reason_of(int error) { return std::generic_category().message(error); }

/// True if it is empty or begins as an audit log does.
bool may_be_written_over(int descriptor) {
  const std::string header = audit_header();
  std::string found(header.size(), '\0');
  const ssize_t got = ::pread(descriptor, found.data(), found.size(), 0);
  return got == 0 || (got == static_cast<ssize_t>(header.size()) && found == header);
}

}  // namespace

LiveAudit::LiveAudit(std::string path,
                     const GuardParameters& parameters,
                     std::vector<std::string> rules)
    : path_(std::move(path)), parameters_(parameters), rules_(std::move(rules)) {
  table::require_output_place(path_);
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
  if (descriptor_ < 0) {
    refuse(path_, reason_of(errno));
  }
  struct stat status {};
  const bool is_file = ::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode);
  if (!is_file || !may_be_written_over(descriptor_)) {
    ::close(descriptor_);
    refuse(path_, "it holds something else; name another file or remove it");
  }
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(descriptor_);
    refuse(path_, "another run writes it");
  }
  was_empty_ = status.st_size == 0;
}

LiveAudit::~LiveAudit() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

int LiveAudit::append(std::string_view rows) noexcept {
  std::string_view left = rows;
  // Only now, at the first tick, does the log of an earlier run go.
  int error = size_ == 0 && ::ftruncate(descriptor_, 0) != 0 ? errno : 0;
  error = error == 0 && ::lseek(descriptor_, size_, SEEK_SET) < 0 ? errno : error;
  while (error == 0 && !left.empty()) {
    const ssize_t written = ::write(descriptor_, left.data(), left.size());
    if (written >= 0) {
      left.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      error = errno;
    }
  }
  if (error == 0) {
    size_ += static_cast<long long>(rows.size());
  } else if (::ftruncate(descriptor_, size_) != 0) {
    return errno;
  }
  return error;
}

void LiveAudit::add(const Tick& tick,
                    const CertifiedTick& certified,
                    const ActedTick& acted,
                    StatusLines& status) {
  text_ = size_ == 0 ? audit_header() : "";
  const std::size_t before = text_.size();
  append_audit_rows(text_, tick, certified, acted, parameters_, rules_);
  if (text_.empty()) {
    return;
  }
  if (const int error = append(text_); error != 0) {
    if (!std::exchange(failed_, true)) {
      status.say("tcert live: cannot write the audit log '" + path_ + "': " + reason_of(error) +
                 "; the run goes on, rows that find no room are counted");
    }
    const auto rows = text_.begin() + static_cast<std::ptrdiff_t>(before);
    lost_ += static_cast<std::size_t>(std::count(rows, text_.end(), '\n'));
  }
}

bool LiveAudit::close(StatusLines& status) {
  if (size_ == 0 && (was_empty_ || failed_) && append(audit_header()) != 0) {
    ++lost_;
  }
  const bool closed = ::close(std::exchange(descriptor_, -1)) == 0;
  if (!closed) {
    status.say("tcert live: the audit log '" + path_ + "' may not be whole: " + reason_of(errno));
  }
  if (lost_ > 0) {
    status.say("tcert live: " + std::to_string(lost_) + " rows of the audit log were lost.");
  }
  return closed && lost_ == 0;
}

}  // namespace tcert::cli
