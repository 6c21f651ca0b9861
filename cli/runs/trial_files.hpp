#pragma once
/// \file
/// The files of one certified trial, written from whichever thread certified it.

#include <span>
#include <string>
#include <tcert/robot.hpp>

#include "analysis/study/trials/study.hpp"
#include "cli/runs/certify_trials.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/result_folder.hpp"
#include "datasets/range_rule.hpp"
#include "reports/series.hpp"

namespace tcert::cli {

/// Its series with its edges, and its ticks, as far as they are asked for. \throws WriteError.
void write_trial_files(const study::StudiedTrial& trial,
                       const ResultFolder& folder,
                       const CertifyFiles& files,
                       const SeriesFormat& format,
                       const Robot& robot,
                       std::span<const RangeKeys> range_keys);

/// Its proof, if it has one: of the trial, or of its edges. \throws WriteError.
void write_witness(const study::StudiedTrial& trial,
                   const std::string& log_sha256,
                   const OpenedBundle& opened,
                   const Robot& robot,
                   const ResultFolder& folder);

/// What it tells other robots. \throws WriteError.
void write_submap(const study::StudiedTrial& trial,
                  const std::string& log_sha256,
                  const OpenedBundle& opened,
                  const Robot& robot,
                  const ResultFolder& folder);

}  // namespace tcert::cli
