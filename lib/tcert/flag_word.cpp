#include <tcert/certifier.hpp>
#include <tcert/flag_word.hpp>

namespace tcert {

const char* flag_word(std::uint32_t flag) noexcept {
  switch (flag) {
    case flag_stale:
      return "stale";
    case flag_bad_input:
      return "bad_input";
    case flag_missing_ray:
      return "missing_ray";
    case flag_break:
      return "break";
    case flag_capacity_exceeded:
      return "capacity_exceeded";
    case flag_start_outside:
      return "start_outside";
    case flag_goal_reached:
      return "goal_reached";
    case flag_memory_evicted:
      return "memory_evicted";
    case flag_across_heading:
      return "across_heading";
    default:
      return "";
  }
}

}  // namespace tcert
