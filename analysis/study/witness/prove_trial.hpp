#pragma once
/// \file
/// The witness of one trial: its free space, and the best path found through it.

#include <optional>
#include <string>
#include <tcert/parameters.hpp>
#include <tcert/robot.hpp>
#include <witness/parameters.hpp>
#include <witness/search.hpp>

#include "analysis/study/witness/prove_edges.hpp"
#include "datasets/trial_reader.hpp"

namespace tcert::study {

/// What a trial proves at its end.
struct Proof {
  witness::FreeCells cells;  ///< F_t; no cells if the trial has none.
  Region start;              ///< S as it was taken.
  std::optional<witness::Witness> witness;
  std::string reason;               ///< Why there is no witness; empty if there is one.
  std::optional<EdgeProofs> edges;  ///< Empty unless they were asked for.

  /// T_t in m: the witness's margin. It is issued if that is above 0.
  [[nodiscard]] std::optional<double> certificate_m() const noexcept {
    return witness ? std::optional(witness->checked.margin_m) : std::nullopt;
  }
};

/// The parameters of the ticks of a run: under clearance=witness all but T_t is as under width.
[[nodiscard]] CertificateParameters parameters_of_ticks(CertificateParameters certificate) noexcept;

/// Samples that are ready for F_t: glitches taken out.
[[nodiscard]] witness::Samples witness_samples(const TrialLog& log,
                                               const Robot& robot,
                                               const witness::WitnessParameters& parameters,
                                               const CertificateParameters& certificate);

/// Rebuilds F_t and searches it. A run without a goal, without a sample or with more cells than
/// there is room for has no witness, and the reason says so. With a series the edges of its
/// corridor graph are looked at too, in the same free space.
[[nodiscard]] Proof prove(const witness::Samples& samples,
                          const Robot& robot,
                          const Course& course,
                          const witness::WitnessParameters& parameters,
                          const CertificateParameters& certificate,
                          const TrialSeries* series = nullptr);

}  // namespace tcert::study
