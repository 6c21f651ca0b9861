#pragma once
/// \file
/// The time of each scan of a CARMEN log, and what to say where its stamps carry no order: they are
/// often rounded to six digits (1.01893e+09 for a day), wrapped round zero, or all zero.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/import/carmen_log.hpp"
#include "datasets/import/carmen_record.hpp"

namespace tcert {

class CarmenStamps {
 public:
  explicit CarmenStamps(const CarmenReading& reading) : reading_(reading) {}

  /// The time of the next record, above that of all before it; or why it has none.
  [[nodiscard]] std::optional<CarmenFault> take(const CarmenScan& scan, std::int64_t& time_ns);

  /// Passes over a record that cannot be read: it had its time too.
  void skip() noexcept { ++place_; }

  [[nodiscard]] std::size_t lost() const noexcept { return lost_; }  ///< Records without a time.

  /// "ipc_timestamp" or "logger_timestamp".
  [[nodiscard]] const char* field() const noexcept;
  /// "3 different stamps in 395 scans".
  [[nodiscard]] std::string summary() const;
  /// What was expected, and what else can be done.
  [[nodiscard]] std::string way_out() const;

 private:
  /// Stamps that rise so far.
  struct Rising {
    std::optional<std::int64_t> last_ns;
    std::size_t count = 0;

    /// True if the stamp is a time above the last one, which it is from then on.
    bool take(std::string_view stamp) noexcept;
  };

  CarmenReading reading_;
  std::size_t place_ = 0;
  std::size_t lost_ = 0;
  Rising used_;
  Rising logger_;
  std::vector<std::string_view> stamps_;
};

}  // namespace tcert
