#include <array>

#include "analysis/study/trials/feature_table.hpp"

namespace tcert::study {
namespace {

template <auto kMember>
std::optional<double> get(const Features& features) {
  const auto& value = features.*kMember;
  return value ? std::optional(static_cast<double>(*value)) : std::nullopt;
}

template <auto kMember>
constexpr FeatureColumn column(std::string_view name,
                               std::string_view unit,
                               std::string_view meaning) {
  return {name, unit, meaning, &get<kMember>};
}

constexpr auto kColumns = std::to_array<FeatureColumn>({
    column<&Features::tc_early>("tc_early", "m", "early certificate margin, worse of the windows"),
    column<&Features::contacts_per_m>("contacts_per_m", "1/m", "contacts begun per metre"),
    column<&Features::dwell>("dwell", "", "share of time standing still"),
    column<&Features::bend_variance>(
        "bend_variance",
        "rad^2",
        "mean variance of the rays' readings; of range rays, of reading / reach"),
    column<&Features::tc_landmark>("tc_landmark", "m", "tc_early of the time window alone"),
    column<&Features::contacts_per_m_landmark>(
        "contacts_per_m_landmark", "1/m", "contacts_per_m of the time window alone"),
    column<&Features::dwell_landmark>("dwell_landmark", "", "dwell of the time window alone"),
    column<&Features::bend_variance_landmark>(
        "bend_variance_landmark", "rad^2", "bend_variance of the time window alone"),
    column<&Features::ticks>("ticks", "", "ticks of the log"),
    column<&Features::ticks_early>("ticks_early", "", "usable ticks in the poorer early window"),
    column<&Features::ticks_landmark>("ticks_landmark", "", "usable ticks in the time window"),
    column<&Features::end_s>("end_s", "s", "time from the first tick to the last"),
    column<&Features::travel_m>("travel_m", "m", "way driven by the last tick, as in the series"),
    column<&Features::window_end_s>(
        "window_end_s", "s", "when the last window closed, seconds since the first tick"),
    column<&Features::still_at_landmark>(
        "still_at_landmark", "", "1 if standing still when the time window closed"),
    column<&Features::issued>("issued", "", "1 if T_t was above 0 at any tick"),
    column<&Features::issued_s>("issued_s", "s", "when first, seconds since the first tick"),
    column<&Features::certificate_m>(
        "certificate_m", "m", "T_t at the last tick; empty if no path joined S and G"),
    column<&Features::issued_before_goal>(
        "issued_before_goal", "", "1 if it was issued before the robot was inside G"),
    column<&Features::certificate_falls>("certificate_falls", "", "ticks at which T_t fell"),
});

}  // namespace

std::span<const FeatureColumn> feature_columns() noexcept { return kColumns; }

}  // namespace tcert::study
