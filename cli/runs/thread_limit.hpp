#pragma once
/// \file
/// How many threads parallel work may take.

#include <cstdint>
#include <memory>

namespace tcert::cli {

/// Bounds the threads of all parallel work while it lives; 0 takes all cores.
class ThreadLimit {
 public:
  explicit ThreadLimit(std::int64_t threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tcert::cli
