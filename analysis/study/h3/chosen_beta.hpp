#pragma once
/// \file
/// H3 with one beta a law, chosen before the outcomes that judge it are seen: beforehand, or by
/// folds of clusters; and what may be said of all laws and lightings at once.

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "analysis/study/h3/hypothesis_h3.hpp"
#include "analysis/study/h3/replay_rows.hpp"

namespace tcert::study {

/// All trials of both algorithms as the choice and its statistic run over them.
struct ChoiceRows {
  std::vector<std::string> laws;
  std::vector<std::vector<std::size_t>> cases_of_law;  ///< Into the cases, by rising beta.
  std::vector<double> beta;                            ///< Of each case.
  std::vector<std::string> lightings;

  // One a trial.
  std::vector<std::uint32_t> cluster;
  std::vector<std::size_t> fold;
  std::vector<std::size_t> lighting;
  std::vector<std::uint8_t> baseline;
  std::vector<std::uint8_t> failed;             ///< Ungated.
  std::vector<double> length, time;             ///< 0 unless it succeeds and both are known.
  std::vector<std::vector<double>> gated_time;  ///< [case][trial], likewise.
  std::vector<std::vector<std::uint8_t>> lost;  ///< [case][trial].
  std::size_t folds = 1;

  [[nodiscard]] std::size_t rows() const noexcept { return cluster.size(); }
};

/// Clusters, in byte order, go to the folds in turn.
[[nodiscard]] ChoiceRows choice_rows(const ReplayRows& rows,
                                     const Grouped& grouped,
                                     std::size_t folds);

/// The case that each law is set to in each fold ([law][fold]) when trials stand `multiplicity`
/// times: of the trials of the other folds the one with the largest rate of advance among those
/// that lose at most `margin` of them, or if none does the one that loses least. O(trials cases).
[[nodiscard]] std::vector<std::vector<std::size_t>> chosen_by_folds(
    const ChoiceRows& rows, double margin, std::span<const std::uint32_t> multiplicity);

/// Of every law, under all lightings and under each. `groups` says what is withheld. Resamples draw
/// clusters of both algorithms jointly and choose anew in each. \throws std::invalid_argument if a
/// law was not replayed at the beta that was asked for, with those that it was.
[[nodiscard]] std::vector<H3Chosen> chosen_cases(const ReplayRows& rows,
                                                 const Grouped& grouped,
                                                 const std::vector<H3Group>& groups,
                                                 const H3Options& options,
                                                 const Watch& watch);

}  // namespace tcert::study
