#include "datasets/import/carmen_stamps.hpp"

#include <algorithm>
#include <cmath>
#include <table/csv_write.hpp>
#include <table/decimal.hpp>
#include <table/diagnostic.hpp>

namespace tcert {
namespace {

std::optional<std::int64_t> nanoseconds_of(std::string_view stamp) noexcept {
  std::int64_t time_ns = 0;
  const bool is_time = !stamp.empty() && table::scan_seconds(stamp.data(), '.', time_ns) ==
                                             stamp.data() + stamp.size();
  return is_time ? std::optional(time_ns) : std::nullopt;
}

}  // namespace

bool CarmenStamps::Rising::take(std::string_view stamp) noexcept {
  const std::optional<std::int64_t> time_ns = nanoseconds_of(stamp);
  if (!time_ns || (last_ns && *time_ns <= *last_ns)) {
    return false;
  }
  last_ns = time_ns;
  ++count;
  return true;
}

std::optional<CarmenFault> CarmenStamps::take(const CarmenScan& scan, std::int64_t& time_ns) {
  const std::size_t place = place_++;
  if (reading_.clock == CarmenClock::order) {
    time_ns = std::llround(1e9 * static_cast<double>(place) / reading_.rate_hz);
    return std::nullopt;
  }
  const bool is_logger = reading_.clock == CarmenClock::logger;
  const std::string_view stamp = is_logger ? scan.logger_timestamp : scan.ipc_timestamp;
  stamps_.push_back(stamp);
  static_cast<void>(logger_.take(scan.logger_timestamp));
  const std::optional<std::int64_t> before_ns = used_.last_ns;
  if (used_.take(stamp)) {
    time_ns = *used_.last_ns;
    return std::nullopt;
  }
  ++lost_;
  const std::optional<std::int64_t> own_ns = nanoseconds_of(stamp);
  if (!own_ns) {
    return CarmenFault{field(), table::shortened(stamp), "a time in seconds"};
  }
  std::string found;
  table::append_seconds(found, *own_ns);
  found += " after ";
  table::append_seconds(found, before_ns.value_or(0));
  return CarmenFault{field(), found, "a time after that of the scan before"};
}

const char* CarmenStamps::field() const noexcept {
  return reading_.clock == CarmenClock::logger ? "logger_timestamp" : "ipc_timestamp";
}

std::string CarmenStamps::summary() const {
  std::vector<std::string_view> stamps = stamps_;
  std::ranges::sort(stamps);
  const auto last = std::unique(stamps.begin(), stamps.end());
  const auto different = static_cast<std::size_t>(last - stamps.begin());
  return std::to_string(different) + (different == 1 ? " different stamp" : " different stamps") +
         " in " + std::to_string(stamps.size()) + " scans";
}

std::string CarmenStamps::way_out() const {
  std::string text = "stamps that rise from scan to scan";
  if (reading_.clock == CarmenClock::ipc && 10 * logger_.count >= 9 * stamps_.size()) {
    text += "; those of the logger do: --clock logger";
  }
  return text +
         "; --clock order --rate HZ makes them from the order of the records (speeds and gaps "
         "depend on them, margins do not)";
}

}  // namespace tcert
