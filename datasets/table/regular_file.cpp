#include <table/regular_file.hpp>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace tcert::table {
namespace {

constexpr std::size_t kPlausibleSize = std::size_t{64} << 20U;
constexpr std::size_t kLargestRatio = 200;

}  // namespace

void require_resources(const std::filesystem::path& path, int error) {
  if (error == EMFILE || error == ENFILE || error == ENOMEM) {
    throw OutOfResources("cannot open '" + path.string() +
                         "': " + std::generic_category().message(error) +
                         "; raise the limit ('ulimit -n') or take fewer --threads");
  }
}

int open_regular_file(const std::filesystem::path& path, std::string& problem) {
  // Not to wait for whoever might write into a pipe.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) {
    const int error = errno;
    require_resources(path, error);
    problem = std::generic_category().message(error);
    return -1;
  }
  struct stat status {};
  if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode)) {
    return descriptor;
  }
  ::close(descriptor);
  errno = S_ISDIR(status.st_mode) ? EISDIR : EINVAL;
  problem = S_ISDIR(status.st_mode) ? std::generic_category().message(EISDIR)
                                    : "it is a pipe, a socket or a device, not a file";
  return -1;
}

bool is_plausible_expansion(std::size_t packed, std::size_t size) noexcept {
  return size <= kPlausibleSize || size / kLargestRatio <= packed;
}

}  // namespace tcert::table
