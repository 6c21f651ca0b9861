#pragma once
/// \file
/// The series of a trial as CSV, one row a tick: what `certify` writes and what `live` prints.

#include <optional>
#include <span>
#include <string>
#include <tcert/certifier.hpp>
#include <tcert/robot.hpp>
#include <tcert/runtime.hpp>
#include <tcert/speed_law.hpp>
#include <tcert/tick.hpp>
#include <vector>

#include "reports/column_doc.hpp"
#include "reports/table.hpp"

namespace tcert {

struct SeriesFormat {
  SpeedLaw speed_law;
  bool ray_margins = false;                 ///< One more column a ray: m_t(theta_k).
  std::optional<SyntheticLabel> synthetic;  ///< A last column `synthetic_seed`.
  bool guards = false;                      ///< Seven more columns: the command and the guards.
  bool risk = false;                        ///< One more: the chance of a collision ahead.
  bool validity = false;                    ///< One more: valid_for_s, where obstacles move.
  std::vector<std::string> rules{};         ///< One more if there are any: those that alarm.
};

/// Their names, in their order.
[[nodiscard]] std::vector<std::string> names_of(const std::vector<Rule>& rules);

/// The columns of every series, in order, and those of `ray_margins` and `synthetic` after them.
[[nodiscard]] std::vector<ColumnDoc> series_columns();

/// Header, ended by a newline.
[[nodiscard]] std::string series_header(const SeriesFormat& format, const Robot& robot);

/// Appends one row, ended by a newline. What is not known at the tick, and a value that is minus
/// infinity because there is no path yet, is an empty cell. Numbers read back to the same bits.
/// `ray_margins` are those of the certifier after the tick, `acted` what follows from it and
/// `yaw_rate_cmd_rps` the command beside v_t; looked at only if the format has them.
void append_series_row(std::string& out,
                       const Tick& tick,
                       const CertifiedTick& certified,
                       std::span<const double> ray_margins,
                       const SeriesFormat& format,
                       const ActedTick& acted = {},
                       double yaw_rate_cmd_rps = kMissing);

/// Words of CertifiedTick::flags, joined by '+': "stale+break"; empty if there are none.
[[nodiscard]] std::string flag_words(std::uint32_t flags);

}  // namespace tcert
