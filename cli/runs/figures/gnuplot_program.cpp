#include "cli/runs/figures/gnuplot_program.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace tcert::cli {
namespace {

/// The child: never returns.
[[noreturn]] void become_gnuplot(const std::filesystem::path& folder,
                                 const std::string& script,
                                 const std::string& form,
                                 int error_pipe) {
  ::setenv("LC_ALL", "C.UTF-8", 1);
  ::dup2(error_pipe, STDERR_FILENO);
  const int nothing = ::open("/dev/null", O_RDWR);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(nothing, STDOUT_FILENO);
  if (::chdir(folder.c_str()) == 0) {
    ::execlp("gnuplot", "gnuplot", "-c", script.c_str(), form.c_str(), nullptr);
  }
  ::_exit(127);
}

std::string read_all(int file) {
  std::string text;
  std::array<char, 4096> buffer{};
  for (;;) {
    const ssize_t got = ::read(file, buffer.data(), buffer.size());
    if (got > 0) {
      text.append(buffer.data(), static_cast<std::size_t>(got));
    } else if (got == 0 || errno != EINTR) {
      return text;
    }
  }
}

}  // namespace

bool has_gnuplot() {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (::access((folder + "/gnuplot").c_str(), X_OK) == 0) {
      return true;
    }
  }
  return false;
}

void run_gnuplot(const std::filesystem::path& folder,
                 const std::string& script,
                 const std::string& form) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) {
    throw std::system_error(errno, std::generic_category(), "cannot make a pipe");
  }
  const pid_t child = ::fork();
  if (child == 0) {
    become_gnuplot(folder, script, form, pipe[1]);
  }
  ::close(pipe[1]);
  const std::string words = child < 0 ? std::string() : read_all(pipe[0]);
  ::close(pipe[0]);
  int status = -1;
  while (child > 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (child < 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw std::runtime_error("gnuplot -c " + script + " " + form + " failed: " + words);
  }
}

}  // namespace tcert::cli
