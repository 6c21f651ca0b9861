#pragma once
/// \file
/// Who drives when, and who fails: Table 1 of the paper laid out over days, before anything moves.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tcert {

enum class Algorithm : std::uint8_t { cb_v, m1, m2, m3, td_lite, tvfh };
enum class Lighting : std::uint8_t { dark, indoor, outdoor };

inline constexpr std::size_t kAlgorithms = 6;
inline constexpr std::size_t kLightings = 3;
inline constexpr std::size_t kTrialsPerBlock = 660;
inline constexpr std::size_t kDaysPerBlock = 22;
inline constexpr std::size_t kTrialsPerDay = 30;

/// As printed in the paper and written to trials.csv: "TD*Lite", "Outdoor".
[[nodiscard]] std::string_view name_of(Algorithm algorithm) noexcept;
[[nodiscard]] std::string_view name_of(Lighting lighting) noexcept;

/// One cell of Table 1: `successes` of `trials`.
struct Cell {
  Algorithm algorithm{};
  Lighting lighting{};
  std::uint32_t trials = 0;
  std::uint32_t successes = 0;
};

/// Table 1 in the order of its rows, then its columns. The caption's counts add up to twice the
/// stated 660, and every printed rate fits the halved ones, which stand here.
[[nodiscard]] const std::array<Cell, kAlgorithms * kLightings>& table_of_cells() noexcept;

/// What is settled about a trial before it is driven.
struct TrialDesign {
  std::uint64_t seed = 1;
  std::uint64_t index = 0;  ///< k, counted over all blocks from 0.
  Algorithm algorithm{};
  Lighting lighting{};
  std::uint64_t day = 0;           ///< Counted over all blocks from 0; a day is one batch.
  double day_level = 0.0;          ///< Of the lanes' width on that day, in standard deviations.
  double day_calibration_m = 0.0;  ///< Added to what every tentacle reads on that day.
  bool success = false;
  double effect = 1.0;        ///< Scales how far the outcomes' tightness lies apart; 0: no effect.
  bool native_rates = false;  ///< Streams at 83/50/20 Hz instead of 20 Hz.
  /// Of the streams' clocks and noise alone: the same drive, logged again. Empty: `seed`.
  std::optional<std::uint64_t> noise_seed{};
};

struct CorpusOptions {
  std::uint64_t seed = 1;
  std::uint64_t trials = kTrialsPerBlock;  ///< At least 1; 660 a block.
  double effect = 1.0;                     ///< In [0, 2]; 0 makes a null corpus.
  bool native_rates = false;
  /// Make only these trials of the `trials`, in this order; empty: all of them.
  std::vector<std::uint64_t> subset;
};

/// \throws std::invalid_argument naming the option that is out of range.
void validate(const CorpusOptions& options);

/// The 660 trials of one block, trials 660 block ... 660 block + 659. It depends on nothing but the
/// options' seed, effect and rates and on the block, so any subset can be made anywhere.
///
/// Each day takes at most two trials more of a cell than any other day does; its 30 trials are in
/// random order. Which trials of a cell fail is a random choice of its own.
[[nodiscard]] std::vector<TrialDesign> design_block(const CorpusOptions& options,
                                                    std::uint64_t block);

/// What a day does, counted over all blocks from 0.
struct DayEffect {
  double level = 0.0;          ///< Of the lanes' width, in standard deviations.
  double calibration_m = 0.0;  ///< Added to what every tentacle reads.
};

/// That of one day of a seed. O(22).
[[nodiscard]] DayEffect day_effect(std::uint64_t seed, std::uint64_t day);

/// The design of trial k alone. O(660).
[[nodiscard]] TrialDesign design_trial(const CorpusOptions& options, std::uint64_t index);

/// "t0000042": seven digits or more, the trial's index from 0.
[[nodiscard]] std::string trial_name(std::uint64_t index);

}  // namespace tcert
