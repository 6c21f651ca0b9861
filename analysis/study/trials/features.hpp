#pragma once
/// \file
/// What the early window of a trial shows (paper 3.2): the certificate's feature and its rivals.

#include <cstddef>
#include <optional>
#include <span>
#include <tcert/certifier.hpp>
#include <tcert/robot.hpp>

#include "datasets/ticks.hpp"

namespace tcert::study {

/// Which ticks of a trial are early. Time and travel count from the first tick.
enum class EarlyWindowKind {
  both,      ///< Two windows, time and distance; the worse value of the two counts.
  landmark,  ///< The time window alone: fixed beforehand, whatever the trial does.
  fraction,  ///< Shares of the final time and of the final travel. Uses the outcome: leaks.
};

/// See early_window.def.
struct EarlyWindowOptions {
#define TCERT_WORD TCERT_MEMBER_WORD
#define TCERT_NUMBER TCERT_MEMBER_NUMBER
#include "analysis/study/trials/early_window.def"
};

/// See <tcert/parameter_fields.hpp>; the first argument only names the list.
template <class Visit>
void visit_fields(const EarlyWindowOptions& /*list*/, Visit&& visit) {
  using Group = EarlyWindowOptions;
#define TCERT_WORD TCERT_VISIT_WORD
#define TCERT_NUMBER TCERT_VISIT_NUMBER
#include "analysis/study/trials/early_window.def"
}

/// \throws std::invalid_argument naming the option and the range it must lie in.
void validate(const EarlyWindowOptions& options);

/// One trial. Empty is missing (NA). The plain features follow `kind`, the `_landmark` ones always
/// the time window. Where there are two windows, a feature is the worse of its two values in its
/// a-priori direction: the smaller one of the certificate, the larger one of each rival.
struct Features {
  std::optional<double> tc_early;  ///< Quantile of tc_t in metres.
  std::optional<double> tc_landmark;

  std::optional<double> contacts_per_m;  ///< Contacts that began / metres travelled.
  std::optional<double> contacts_per_m_landmark;
  std::optional<double> dwell;  ///< Share of time spent slower than dwell_speed_mps.
  std::optional<double> dwell_landmark;
  std::optional<double> bend_variance;  ///< Mean over rays; rad^2, or of clearance / reach.
  std::optional<double> bend_variance_landmark;

  std::optional<std::size_t> ticks;           ///< Of the trial's log.
  std::optional<std::size_t> ticks_early;     ///< Usable ones; of two windows, in the poorer one.
  std::optional<std::size_t> ticks_landmark;  ///< Usable ones in the time window.
  std::optional<double> end_s;                ///< Time of the last tick.
  std::optional<double> travel_m;             ///< At the last tick.
  std::optional<double> window_end_s;  ///< When the last window closed; NA if the log ends first.
  std::optional<bool> still_at_landmark;   ///< Dwelling at the end of the time window.
  std::optional<bool> issued;              ///< T_t > 0 at some tick.
  std::optional<double> issued_s;          ///< When first.
  std::optional<double> certificate_m;     ///< Final T_t; NA if S and G were never connected.
  std::optional<bool> issued_before_goal;  ///< Issued at a tick before the robot was inside G.
  std::optional<std::size_t> certificate_falls;  ///< Ticks at which T_t fell: 0 if it is sound.
};

/// Usable ticks are the fresh ones. A window with fewer than min_ticks of them has no values; one
/// with a -infinity among them (no path from S yet) has no certificate feature.
///
/// - Contacts per metre: NA without travel.
/// - Dwell: speed is the displacement over the trailing dwell_window_s divided by that time, since
///   tick-to-tick displacement at a standstill is pose noise; ticks weigh by the time since the
///   tick before. No speed is known for the first dwell_window_s, nor after a break of the path.
/// - Bend variance: per ray over the fresh ticks, n - 1; a ray with fewer than two readings is left
///   out; NA without such a ray.
///
/// O(ticks x rays). \throws std::invalid_argument if `series` is not as long as `ticks` or the
/// table has other rays than the robot. \pre validate(options) passes.
[[nodiscard]] Features early_features(const Robot& robot,
                                      const TickTable& ticks,
                                      std::span<const CertifiedTick> series,
                                      const EarlyWindowOptions& options = {});

/// What the series says of the certificate: issued or not, when, and T_t at the end. O(ticks).
/// \pre there is a tick, and one of the series for each.
void add_certificate(const TickTable& ticks,
                     std::span<const CertifiedTick> series,
                     Features& features);

}  // namespace tcert::study
