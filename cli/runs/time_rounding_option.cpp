#include "cli/runs/time_rounding_option.hpp"

namespace tcert::cli {

void add_time_rounding_option(OptionTable& table, bool& off) {
  table.add("no-time-rounding",
            off,
            "times: keep those apart that differ by rounding (5e-7, or a millionth of the "
            "time if that is less), which are one time otherwise");
}

}  // namespace tcert::cli
