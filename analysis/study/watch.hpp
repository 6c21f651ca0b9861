#pragma once
/// \file
/// Whom a long study tells how far it is. It knows no terminal; what is computed is the same
/// whether anybody watches or not.

#include <cstddef>
#include <functional>
#include <string>

namespace tcert::study {

struct Watch {
  /// A part of the study begins, which has so many equal steps; the part before it is done.
  std::function<void(const std::string& part, std::size_t steps)> on_begin{};
  /// A step is done; called by several threads at a time.
  std::function<void()> on_advance{};

  void begin(const std::string& part, std::size_t steps) const {
    if (on_begin) {
      on_begin(part, steps);
    }
  }
  void advance() const {
    if (on_advance) {
      on_advance();
    }
  }
};

}  // namespace tcert::study
