// Any text as rules: refused, or rules that can be watched, and whose robustness is a range.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <tcert/rule_monitor.hpp>

#include "fuzz/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    tcert::RuleMonitor monitor(tcert::parse_rules(text));
    std::int64_t time_ns = 0;
    for (std::size_t i = 0; i < 50; ++i) {
      tcert::SignalValues signals{};
      for (std::size_t k = 0; k < signals.size(); ++k) {
        const std::uint8_t byte = size == 0 ? std::uint8_t{0} : data[(31 * i + k) % size];
        signals[k] = byte == 255 ? tcert::kMissing : static_cast<double>(byte) - 100.0;
      }
      monitor.update(time_ns, signals);
      time_ns += 50'000'000 * static_cast<std::int64_t>(1 + i % 7);
      for (const tcert::RuleState& state : monitor.states()) {
        tcert::fuzz::require(state.robustness.low <= state.robustness.high,
                             "a lower bound is not above the upper one");
      }
    }
  } catch (const std::invalid_argument&) {
    // Most texts are none.
  }
  return 0;
}
