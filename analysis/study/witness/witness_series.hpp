#pragma once
/// \file
/// The series of a trial whose certificate is that of its witnesses.

namespace tcert::study {

struct StudiedTrial;

/// Takes T_t out of the series, edges' bottleneck and features of `trial`, and puts in its place
/// the largest margin that a look has proved by then; at the last tick the proof of the trial
/// counts, too. All else stays as it is. \pre the trial has a proof.
void certify_by_witness(StudiedTrial& trial);

}  // namespace tcert::study
