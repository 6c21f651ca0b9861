#include <table/temporary_name.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <ctime>
#include <system_error>
#include <table/path_name.hpp>
#include <utility>

namespace tcert::table {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnd = ".tmp";

/// Length of the part of a name that may be cut: what is put round it has at most 40 bytes.
constexpr std::size_t kLongestPart = 210;

/// True if somebody holds a lock on it, or it cannot be known.
bool is_held(const fs::path& path) noexcept {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) {
    return true;
  }
  const bool held = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0;
  ::close(descriptor);
  return held;
}

/// When this process began, by the clock that dates files.
const timespec kBegan = [] {
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME_COARSE, &now);
  return now;
}();

bool is_older_than_we(const struct stat& status) noexcept {
  const timespec& changed = status.st_ctim;
  return changed.tv_sec < kBegan.tv_sec ||
         (changed.tv_sec == kBegan.tv_sec && changed.tv_nsec < kBegan.tv_nsec);
}

/// True if the process that made a temporary is there. Our own number may have been that of another
/// before us, as in a container: what is older than we are is not ours.
bool lives(pid_t process, const struct stat& made) noexcept {
  return process == ::getpid() ? !is_older_than_we(made)
                               : ::kill(process, 0) == 0 || errno == EPERM;
}

void sweep(const fs::path& folder, const std::string* name) noexcept {
  try {
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
      const auto temporary = swept_name_from(at->path().filename().native());
      if (temporary && (name == nullptr || temporary->name == *name) &&
          is_forsaken(at->path(), *temporary)) {
        std::error_code ignored;
        fs::remove_all(at->path(), ignored);
      }
    }
  } catch (const std::exception&) {
    return;  // What is not swept now is swept another time.
  }
}

}  // namespace

std::string name_in_temporary(const fs::path& path) {
  std::string name = path.filename().string();
  if (auto temporary = swept_name_from(name)) {
    name = std::move(temporary->name);
  }
  return name.substr(0, kLongestPart);
}

fs::path temporary_name(const fs::path& path, Leftover leftover) {
  static std::atomic<unsigned> next{0};
  std::string name(1, '.');
  name += name_in_temporary(path);
  name += '.';
  name += std::to_string(::getpid());
  name += '-';
  name += std::to_string(next++);
  name += leftover == Leftover::kept ? ".kept" : "";
  name += kEnd;
  return path.has_parent_path() ? path.parent_path() / name : fs::path(name);
}

std::optional<TemporaryName> swept_name_from(std::string_view name) {
  if (!is_temporary_name(name)) {
    return std::nullopt;
  }
  name.remove_prefix(1);
  name.remove_suffix(kEnd.size());
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos || dot == 0) {
    return std::nullopt;
  }
  const std::string_view numbers = name.substr(dot + 1);
  const char* const end = numbers.data() + numbers.size();
  TemporaryName result{std::string(name.substr(0, dot)), 0};
  unsigned count = 0;
  const auto [dash, first] = std::from_chars(numbers.data(), end, result.process);
  if (first != std::errc{} || dash == end || *dash != '-' || result.process <= 0) {
    return std::nullopt;
  }
  const auto [rest, second] = std::from_chars(dash + 1, end, count);
  return second == std::errc{} && rest == end ? std::optional(std::move(result)) : std::nullopt;
}

bool is_forsaken(const fs::path& path, const TemporaryName& name) noexcept {
  struct stat status {};
  return ::lstat(path.c_str(), &status) == 0 &&
         (S_ISREG(status.st_mode) || S_ISDIR(status.st_mode)) && !lives(name.process, status) &&
         !is_held(path);
}

void sweep_leftovers(const fs::path& path) noexcept {
  const fs::path place = path.has_filename() ? path : path.parent_path();
  const std::string name = name_in_temporary(place);
  sweep(place.has_parent_path() ? place.parent_path() : fs::path("."), &name);
}

void sweep_leftovers_in(const fs::path& folder) noexcept { sweep(folder, nullptr); }

}  // namespace tcert::table
