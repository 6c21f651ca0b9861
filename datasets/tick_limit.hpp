#pragma once
/// \file
/// How many ticks the log of a trial may become.

#include <optional>
#include <string>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/trial_reader.hpp"

namespace tcert {

/// Takes a log away, with an error of its trial, whose time stamps span more than 2^24 ticks of
/// `tick_s`, silences of more than a minute left out: five days at a tick of 1/40 s. To be asked
/// before resample(), which takes the memory of as many.
void reject_too_many_ticks(std::optional<TrialLog>& log,
                           double tick_s,
                           const std::string& trial_id,
                           std::vector<table::Diagnostic>& diagnostics);

}  // namespace tcert
