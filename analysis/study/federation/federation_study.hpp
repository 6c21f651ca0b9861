#pragma once
/// \file
/// How several robots that share the way of one random world fare together: is T_H at most the
/// truth, how soon is it issued, and how much do they send.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <table/row_text.hpp>
#include <vector>

#include "datasets/random_worlds/random_world.hpp"

namespace tcert::study {

inline constexpr std::array<std::size_t, 4> kTeams{1, 2, 4, 8};

/// Whose margins the robots send, and by how much their frames are off.
enum class FederationMethod : std::uint8_t { witness, witness_frames, width };
inline constexpr std::array kFederationMethods{
    FederationMethod::witness, FederationMethod::witness_frames, FederationMethod::width};
[[nodiscard]] std::string_view name_of(FederationMethod method) noexcept;

/// Each robot's frame in `witness_frames`: any place is off by up to this, and any heading.
inline constexpr double kFrameErrorM = 0.02;
inline constexpr double kFrameErrorRad = 0.002;

/// One team in one world, by one method. Times are since all robots set off.
struct TeamOutcome {
  double certificate_m = 0.0;    ///< T_H when all have come to their ends; -infinity: none.
  double best_alone_m = 0.0;     ///< The best of the robots' own.
  std::optional<double> time_s;  ///< Until T_H is issued.
  /// Longest time that a robot has spent by then, or by its end, where no other had told of.
  double dwell_s = 0.0;
  std::uint32_t joins = 0;
  std::uint32_t edges = 0;
  std::uint32_t bytes = 0;  ///< Of all submaps.
};

void row_cells(auto& row, table::Is<TeamOutcome> auto& team) {
  row(team.certificate_m, team.best_alone_m, team.time_s, team.dwell_s);
  row(team.joins, team.edges, team.bytes);
}

struct FederationOutcome {
  WorldFamily family = WorldFamily::gates;
  double truth_m = 0.0;            ///< T_upper by clearance.
  std::vector<TeamOutcome> teams;  ///< By team, then by method.
};

void row_cells(auto& row, table::Is<FederationOutcome> auto& world) {
  row(world.family, world.truth_m, world.teams);
}

/// Worlds of even numbers are mixed ones, of odd numbers hard ones. Of n robots number k sets off
/// at k/n of the way and drives two n-ths of it, to the end at most, each by a walk of its own; all
/// feel true ticks. An edge counts from the tick at which it closed, with the margin that it has in
/// the end.
[[nodiscard]] FederationOutcome federate_world(std::uint64_t seed, std::uint64_t index);

}  // namespace tcert::study
