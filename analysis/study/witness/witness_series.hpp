#pragma once
/// \file
/// The series of a trial whose certificate is that of its witness.

namespace tcert::study {

struct StudiedTrial;

/// Takes T_t out of the series, edges' bottleneck and features of `trial`, and puts the witness's
/// margin at the last tick in its place: a witness is found at the end of a trial.
/// All else stays as it is. \pre the trial has a proof.
void certify_by_witness(StudiedTrial& trial);

}  // namespace tcert::study
