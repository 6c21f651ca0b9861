#include "support/workdir.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace tcert::test_support {
namespace {

namespace fs = std::filesystem;

std::string read_all(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// In the child: only calls that are safe between fork and exec.
[[noreturn]] void become(const char* program,
                         char* const* argv,
                         const char* directory,
                         const char* in,
                         const char* out,
                         const char* err) {
  const bool ready = ::chdir(directory) == 0 && ::dup2(::open(in, O_RDONLY), STDIN_FILENO) >= 0 &&
                     ::dup2(::open(out, O_WRONLY | O_CREAT | O_TRUNC, 0666), STDOUT_FILENO) >= 0 &&
                     ::dup2(::open(err, O_WRONLY | O_CREAT | O_TRUNC, 0666), STDERR_FILENO) >= 0;
  if (ready) {
    ::execv(program, argv);
  }
  ::_exit(127);
}

}  // namespace

std::string to_string(const ProcessResult& run) {
  return "command: " + run.command + "\nexit code: " + std::to_string(run.exit_code) +
         "\nstdout:\n" + run.out.substr(0, 4000) + "\nstderr:\n" + run.err.substr(0, 4000);
}

Workdir::Workdir(std::string program) : program_(std::move(program)) {
  static std::atomic<int> next{0};
  path_ = fs::temp_directory_path() /
          ("tcert_test_" + std::to_string(::getpid()) + "_" + std::to_string(next++));
  fs::remove_all(path_);
  fs::create_directories(path_);
}

Workdir::~Workdir() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

pid_t Workdir::start(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {program_};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
  const std::string in = path_ / ".stdin";
  const std::string out = path_ / ".stdout";
  const std::string err = path_ / ".stderr";
  const std::string directory = path_;
  if (!fs::exists(in)) {
    std::ofstream(in).flush();
  }
  const pid_t child = ::fork();
  if (child < 0) {
    throw std::runtime_error("cannot fork");
  }
  if (child == 0) {
    become(program_.c_str(), argv.data(), directory.c_str(), in.c_str(), out.c_str(), err.c_str());
  }
  return child;
}

ProcessResult Workdir::run(const std::vector<std::string>& arguments, std::string_view input) {
  write(".stdin", input);
  ProcessResult run;
  run.command = "tcert";
  for (const std::string& argument : arguments) {
    run.command += " " + argument;
  }
  const pid_t child = start(arguments);
  int status = 0;
  if (::waitpid(child, &status, 0) != child) {
    throw std::runtime_error("cannot wait for " + run.command);
  }
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.out = read_all(path_ / ".stdout");
  run.err = read_all(path_ / ".stderr");
  return run;
}

void Workdir::write(std::string_view name, std::string_view text) const {
  const fs::path path = path_ / name;
  fs::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text;
  file.flush();
  if (!file) {
    throw std::runtime_error("cannot write " + path.string());
  }
}

std::string Workdir::read(std::string_view name) const { return read_all(path_ / name); }

std::vector<std::string> Workdir::files(std::string_view name) const {
  std::vector<std::string> names;
  const fs::path root = path_ / name;
  if (!fs::exists(root)) {
    return names;
  }
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (entry.is_regular_file()) {
      names.push_back(entry.path().lexically_relative(root).generic_string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace tcert::test_support
