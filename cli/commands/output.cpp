#include "cli/output.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <table/atomic_file.hpp>
#include <table/printable.hpp>

#include "cli/errors.hpp"

namespace tcert::cli {
namespace {

int silences = 0;

}  // namespace

SilentPrint::SilentPrint() noexcept { ++silences; }

SilentPrint::~SilentPrint() { --silences; }

void print(std::string_view text) {
  if (silences > 0) {
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

void say(std::span<const table::Diagnostic> diagnostics) {
  for (const table::Diagnostic& diagnostic : diagnostics) {
    say(table::to_string(diagnostic));
  }
}

void require_apart(const std::filesystem::path& input, const std::filesystem::path& output) {
  table::require_output_place(output);
  const auto from = std::filesystem::weakly_canonical(input);
  const auto to = std::filesystem::weakly_canonical(output);
  const auto [end, _] = std::mismatch(to.begin(), to.end(), from.begin(), from.end());
  if (end == to.end()) {
    throw UsageError("the output " + output.string() + " would replace the input " +
                     input.string() + "; name another folder");
  }
}

}  // namespace tcert::cli
