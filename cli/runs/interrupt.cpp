#include "cli/runs/interrupt.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <table/atomic_file.hpp>
#include <thread>

namespace tcert::cli {
namespace {

std::atomic<int> told{-1};  // where an interrupt is written to; -1: it ends the process

/// Those that the process was not started to ignore, as nohup does.
sigset_t interrupts() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction now {};
    if (::sigaction(signal, nullptr, &now) != 0 || now.sa_handler != SIG_IGN) {
      sigaddset(&set, signal);
    }
  }
  return set;
}

[[noreturn]] void end_by(int signal, const sigset_t& set) {
  std::signal(signal, SIG_DFL);
  ::kill(::getpid(), signal);
  ::pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  ::_exit(128 + signal);
}

void wait_for(const sigset_t& set) {
  for (;;) {
    int signal = 0;
    if (::sigwait(&set, &signal) != 0) {
      continue;
    }
    const int descriptor = told.exchange(-2);
    if (descriptor >= 0) {
      [[maybe_unused]] const auto written = ::write(descriptor, "", 1);
      continue;
    }
    if (descriptor == -1) {
      table::remove_unfinished();
    }
    end_by(signal, set);
  }
}

}  // namespace

void watch_interrupts() {
  const sigset_t set = interrupts();
  ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
  std::thread([set] { wait_for(set); }).detach();
}

int interrupt_descriptor() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw std::system_error(errno, std::generic_category(), "cannot make a pipe");
  }
  told = ends[1];
  return ends[0];
}

}  // namespace tcert::cli
