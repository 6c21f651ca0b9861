#pragma once
/// \file
/// M3: memory-augmented, it shuns where it has touched before.

#include <tcert/felt_memory.hpp>
#include <tcert/pilot.hpp>

namespace tcert::policies {

/// M1's J + w_M (1/d) int_0^d M(x + s u(theta)) ds, M the core's contact memory, d memory_ahead_m.
/// O(24 (rays + d / memory_cell_m)) a step; a tick that is remembered adds what M costs.
class MemoryPolicy {
 public:
  /// \throws std::invalid_argument if the setup is out of range.
  explicit MemoryPolicy(const PolicySetup& setup) : pilot_(setup), memory_(setup) {}

  Command step(const Senses& senses) noexcept;
  void reset() noexcept;
  [[nodiscard]] Pilot& pilot() noexcept { return pilot_; }
  [[nodiscard]] const Pilot& pilot() const noexcept { return pilot_; }

 private:
  Pilot pilot_;
  FeltMemory memory_;
};

}  // namespace tcert::policies
