#include "cli/commands/output.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <table/atomic_file.hpp>
#include <table/printable.hpp>

#include "cli/runs/errors.hpp"

namespace tcert::cli {
void print(std::string_view text) {
  if (text.empty()) {
    return;
  }
  std::string escaped;
  if (::isatty(STDOUT_FILENO) == 1) {
    escaped = table::printable_lines(text);
    text = escaped;
  }
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) {
    return;
  }
  if (errno == EPIPE) {
    throw BrokenPipe("stdout");
  }
  throw table::WriteError("cannot write to stdout: " + std::generic_category().message(errno));
}

void say(std::string_view lines) {
  const std::string text = table::printable_lines(lines) + '\n';
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace tcert::cli
