#include "cli/runs/verify/check_proofs.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <system_error>
#include <table/bytes.hpp>

#include "analysis/study/trials/parameters.hpp"
#include "cli/runs/bundle_digest.hpp"
#include "cli/runs/verify/find_input.hpp"
#include "datasets/tick_limit.hpp"
#include "datasets/trial_reader.hpp"
#include "reports/witness_check.hpp"

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostProofCells = std::size_t{1} << 30U;  // as max_witness_cells

std::vector<fs::path> proof_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_regular_file() && !entry.is_symlink() && entry.path().extension() == ".json") {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// What does not hold of one proof; empty if it does.
std::string fault_of_proof(const WitnessDocument& proof,
                           const Bundle& bundle,
                           const study::ParameterSet& parameters,
                           const ReadOptions& options) {
  const auto row = std::ranges::find(bundle.trials, proof.trial_id, &TrialRow::trial_id);
  if (row == bundle.trials.end()) {
    return "the bundle has no trial '" + proof.trial_id + "'";
  }
  TrialResult read = read_trial(bundle, *row, options);
  reject_too_many_ticks(read.log, parameters.resample.tick_s, proof.trial_id, read.diagnostics);
  if (!read.log) {
    return "its log cannot be read";
  }
  return fault_of_witness(
      proof, bundle.info, parameters, *read.log, log_digest(bundle, *row).sha256);
}

}  // namespace

void check_proofs(const VerifyTarget& target,
                  const fs::path& results,
                  const std::vector<std::string>& inputs,
                  Finding& finding) {
  const WrittenResult& manifest = target.result.manifest;
  const std::vector<fs::path> files = proof_files(target.result.folder / "witness");
  if (manifest.command != "certify" || !target.file.empty() || files.empty() ||
      !manifest.arguments) {
    return;
  }
  const auto name = std::ranges::find_if(*manifest.arguments, &ManifestArgument::is_input);
  const auto place = name == manifest.arguments->end()
                         ? std::nullopt
                         : find_input(name->text, target, results, inputs);
  const auto is_given = [&](const char* option) {
    return std::ranges::any_of(*manifest.arguments,
                               [&](const ManifestArgument& one) { return one.text == option; });
  };
  const BundleResult opened =
      place ? open_bundle(*place, {is_given("--decimal-comma")}) : BundleResult{};
  if (!opened.bundle) {
    finding.obstacles.emplace_back("its witnesses cannot be checked without its bundle");
    return;
  }
  const ReadOptions options{is_given("--repair")};
  study::ParameterSet parameters;
  try {
    for (const auto& [key, value] : manifest.parameters) {
      if (!value.empty()) {
        study::set_parameter(parameters, key, value);
      }
    }
  } catch (const std::invalid_argument& error) {
    finding.obstacles.push_back(std::string("its witnesses cannot be checked: ") + error.what());
    return;
  }
  std::vector<std::string> faults(files.size());
  tbb::parallel_for(std::size_t{0}, files.size(), [&](std::size_t i) {
    try {
      const table::BytesResult read = table::read_file(files[i]);
      if (!read.bytes) {
        throw WitnessFormatError("it cannot be read");
      }
      const WitnessDocument proof = witness_from_json(read.bytes->view(), kMostProofCells);
      faults[i] = proof.trial_id == files[i].stem().string()
                      ? fault_of_proof(proof, *opened.bundle, parameters, options)
                      : "it is of another trial than its name";
      if (faults[i].empty() && to_json(proof) != read.bytes->view()) {
        faults[i] = "it is not written as the tool writes what it says";
      }
    } catch (const WitnessFormatError& error) {
      faults[i] = error.what();
    } catch (const std::logic_error& error) {  // too many cells, or parameters that are none
      faults[i] = error.what();
    }
  });
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!faults[i].empty()) {
      finding.differences.push_back("'witness/" + files[i].filename().string() + "': " + faults[i]);
    }
  }
}

}  // namespace tcert::cli
