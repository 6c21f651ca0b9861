#include "cli/time_rounding_option.hpp"

namespace tcert::cli {

void add_time_rounding_option(po::options_description& own, bool& off) {
  own.add_options()("no-time-rounding",
                    po::bool_switch(&off),
                    "times: keep those apart that differ by rounding (5e-7, or a millionth of the "
                    "time if that is less), which are one time otherwise");
}

}  // namespace tcert::cli
