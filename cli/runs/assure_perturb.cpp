#include "cli/runs/assure_perturb.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <set>
#include <utility>

#include "cli/runs/bundle_digest.hpp"
#include "cli/runs/data_file.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/result_folder.hpp"
#include "cli/runs/thread_limit.hpp"
#include "cli/runs/written_options.hpp"
#include "datasets/bundle_files.hpp"
#include "datasets/perturb/perturb_trial.hpp"
#include "reports/features_table.hpp"

namespace tcert::cli {
namespace {

constexpr const char* kInjectionsFile = "injections.csv";
constexpr std::array kStreamWords{std::pair("pose", perturb::StreamKind::pose),
                                  std::pair("tactile", perturb::StreamKind::tactile),
                                  std::pair("control", perturb::StreamKind::control)};

std::vector<perturb::StreamKind> links_of(const std::string& list) {
  std::vector<perturb::StreamKind> links;
  for (const std::string& word : words_of(list)) {
    const auto* const found =
        std::ranges::find_if(kStreamWords, [&](const auto& one) { return one.first == word; });
    if (found == kStreamWords.end()) {
      throw UsageError("--streams: found '" + word + "', expected pose, tactile or control");
    }
    links.push_back(found->second);
  }
  return links;
}

/// What is kept of a trial when its files are written.
struct PerturbedRecord {
  std::vector<std::string> sources;  // files that others take the place of
  std::vector<perturb::PerturbedStream> streams;
  std::vector<table::Diagnostic> diagnostics;
  FileDigest digest;
  bool rejected = false;
};

std::vector<PerturbedRecord> perturb_trials(const Bundle& bundle,
                                            const perturb::PerturbPlan& plan,
                                            const ResultFolder& folder,
                                            Progress& progress) {
  std::vector<PerturbedRecord> records(bundle.trials.size());
  Stage stage(progress, "perturbing", records.size());
  std::mutex counting;
  tbb::parallel_for(std::size_t{0}, records.size(), [&](std::size_t i) {
    const TrialRow& row = bundle.trials[i];
    PerturbedRecord& record = records[i];
    if (plan.faults.any()) {
      perturb::PerturbedTrial made = perturb::perturb_trial(bundle, row, plan);
      for (const perturb::PerturbedFile& file : made.files) {
        folder.write(file.name, file.text);
        record.sources.push_back(file.source);
      }
      record.streams = std::move(made.streams);
      record.diagnostics = std::move(made.diagnostics);
      record.rejected = made.rejected;
    }
    record.digest = log_digest(bundle, row);
    const std::lock_guard lock(counting);
    stage.advance();
  });
  return records;
}

std::string raw_file(const BundleFiles& files, const std::string& name) {
  const table::BytesResult file = files.read_raw(name);
  if (!file.bytes) {
    throw BadData("cannot read '" + name + "' of the bundle: " + file.problem);
  }
  return std::string(file.bytes->view());
}

/// Every file of the bundle that nothing takes the place of, as it is.
void copy_others(const std::filesystem::path& bundle,
                 const std::set<std::string>& replaced,
                 const ResultFolder& folder) {
  BundleFiles files(bundle);
  const std::vector<std::string> names = files.names();
  if (!files.problem().empty()) {
    throw BadData("'" + bundle.string() + "': " + files.problem());
  }
  for (const std::string& name : names) {
    if (!replaced.contains(name)) {
      folder.write(name, raw_file(files, name));
    }
  }
}

/// What the bundle had been perturbed by before comes first.
std::string injections_text(const Bundle& bundle, const std::vector<PerturbedRecord>& records) {
  const BundleFiles files(bundle.path);
  std::string text;
  if (files.contains(kInjectionsFile)) {
    text = raw_file(files, kInjectionsFile);
    text += text.empty() || text.back() == '\n' ? "" : "\n";
  } else {
    const auto label = synthetic_label(bundle.info);
    text = (label ? "# " + to_string(*label) + '\n' : "") + perturb::injections_header();
  }
  for (std::size_t i = 0; i < records.size(); ++i) {
    for (const perturb::PerturbedStream& stream : records[i].streams) {
      for (const perturb::Injection& one : stream.injections) {
        perturb::append_injection(
            text, bundle.trials[i].trial_id, stream.name, one, bundle.info.robot.rays);
      }
    }
  }
  return text;
}

/// How much of the samples that it could meet a kind of faults met: of the streams that lose
/// samples and are late, or of those of rays.
struct KindCount {
  std::size_t faults = 0;
  std::size_t met = 0;
  std::size_t samples = 0;
};

bool can_meet(perturb::FaultKind kind,
              perturb::StreamKind stream,
              const std::vector<perturb::StreamKind>& links) {
  const bool is_of_link =
      kind == perturb::FaultKind::dropout || kind == perturb::FaultKind::latency;
  return is_of_link ? std::ranges::find(links, stream) != links.end()
                    : stream == perturb::StreamKind::tactile;
}

KindCount count_of(perturb::FaultKind kind,
                   const std::vector<PerturbedRecord>& records,
                   const std::vector<perturb::StreamKind>& links) {
  KindCount count;
  for (const PerturbedRecord& record : records) {
    for (const perturb::PerturbedStream& stream : record.streams) {
      count.samples += can_meet(kind, stream.kind, links) ? stream.samples : 0;
      for (const perturb::Injection& one : stream.injections) {
        count.faults += one.kind == kind ? 1 : 0;
        count.met += one.kind == kind ? one.samples : 0;
      }
    }
  }
  return count;
}

/// "dropout: 12 (1.9 % of the samples); spike: 3 (...)".
std::string kinds_in_words(const std::vector<PerturbedRecord>& records,
                           const std::vector<perturb::StreamKind>& links) {
  std::string words;
  for (const perturb::FaultKind kind : perturb::kFaultKinds) {
    const KindCount count = count_of(kind, records, links);
    if (count.faults > 0) {
      words +=
          fmt::format("{}{}: {} ({:.3g} % of the samples)",
                      words.empty() ? "" : "; ",
                      perturb::to_string(kind),
                      count.faults,
                      100.0 * static_cast<double>(count.met) / static_cast<double>(count.samples));
    }
  }
  return words.empty() ? "none" : words;
}

ExitCode conclude_perturbing(const AssurePerturbRequest& request,
                             const Bundle& bundle,
                             const std::vector<PerturbedRecord>& records,
                             Progress& progress) {
  std::string rejected;
  for (std::size_t i = 0; i < records.size(); ++i) {
    for (const table::Diagnostic& one : records[i].diagnostics) {
      if (one.severity == table::Severity::error) {
        progress.say(table::to_string(one));
      }
    }
    if (records[i].rejected) {
      rejected += (rejected.empty() ? "" : ", ") + bundle.trials[i].trial_id;
    }
  }
  if (!request.faults.any()) {
    progress.sum_up("No fault was asked for: " + request.output.path + " is the bundle as it was.");
    return exit_done;
  }
  progress.sum_up(
      fmt::format("Faults in {} trials: {}. They are listed in {}.",
                  records.size(),
                  kinds_in_words(records, links_of(request.streams)),
                  (std::filesystem::path(request.output.path) / kInjectionsFile).string()));
  if (rejected.empty()) {
    return exit_done;
  }
  progress.say("copied without faults, for their logs are rejected: " + rejected);
  return exit_rejected;
}

void add_rate(OptionTable& table, const char* name, double& value, const char* text) {
  table.add(name, value, "R", text).within(0, 3600);
}

void add_length(OptionTable& table, const char* name, double& value, const char* text) {
  table.add(name, value, "S", text).within(0.01, 3600);
}

}  // namespace

OptionTable options_of(AssurePerturbRequest& request) {
  perturb::FaultOptions& faults = request.faults;
  OptionTable table(request.given);
  table.argument({"KIND", &request.kind, true, OptionRole::shapes, {"perturb"}});
  table.argument({"BUNDLE", &request.bundle, true, OptionRole::input});
  table
      .add("dropout-good-s",
           faults.dropout_good_s,
           "S",
           "samples are lost: mean time between two losses of a stream, from 0.5; 0 is none")
      .within(0, 1e6);
  add_length(table, "dropout-bad-s", faults.dropout_bad_s, "mean time that a loss lasts");
  add_rate(table,
           "bursts-per-hour",
           faults.bursts_per_hour,
           "latency: bursts of a stream, at whose end all of their samples arrive (arrival_s)");
  add_length(table, "burst-s", faults.burst_s, "how long a burst is");
  add_rate(table,
           "spikes-per-hour",
           faults.spikes_per_hour,
           "half a sine of force, added at the tip of one ray");
  table.add("spike-n", faults.spike_n, "N", "its height").within(0.01, 1e4);
  add_length(table, "spike-width-s", faults.spike_width_s, "how long it lasts");
  add_rate(table,
           "freezes-per-hour",
           faults.freezes_per_hour,
           "one ray goes on to say what it said last, force and all");
  add_length(table, "freeze-s", faults.freeze_s, "for how long");
  add_rate(table,
           "wide-per-hour",
           faults.wide_per_hour,
           "one ray is stuck at a wide reading, without force: the dangerous kind");
  add_length(table, "wide-s", faults.wide_s, "for how long");
  table
      .add("wide-share",
           faults.wide_share,
           "P",
           "what it states, as a share of the longest clearance that it can state")
      .within(0, 1);
  add_rate(table, "biases-per-hour", faults.biases_per_hour, "one ray is off by a constant");
  add_length(table, "bias-s", faults.bias_s, "for how long");
  table.add("bias-whole-trial",
            faults.bias_whole_trial,
            "one ray of each trial is off from its beginning to its end");
  table
      .add("bias-m",
           faults.bias_m,
           "M",
           "by how much clearance; above 0 too wide. A bend is changed through its calibration")
      .within(-10, 10);
  table.add("streams",
            request.streams,
            "WORDS",
            "those that lose samples and are late, comma between: pose, tactile, control");
  add_common(table, request);
  table.config_file();
  return table;
}

ExitCode assure_perturb(const AssurePerturbRequest& request, Progress& progress) {
  const std::string& path = request.output.path;
  if (path.empty()) {
    throw UsageError("needs --output DIR");
  }
  const perturb::FaultOptions& faults = request.faults;
  constexpr double kLeastGoodS = 0.5;
  if (faults.dropout_good_s > 0.0 && faults.dropout_good_s < kLeastGoodS) {
    throw UsageError("--dropout-good-s: found " + std::to_string(faults.dropout_good_s) +
                     ", expected 0 or a value from 0.5 on");
  }
  const perturb::PerturbPlan plan{
      faults, links_of(request.streams), static_cast<std::uint64_t>(request.seed)};
  LogOptions logs;
  logs.decimal_comma = request.decimal_comma;
  const OpenedBundle opened = open_for(request.bundle, logs, progress);
  require_apart(request.bundle, path);
  const ThreadLimit limit(request.threads);
  ResultFolder folder(path, "assure");
  const Bundle& bundle = opened.bundle;
  const std::vector<PerturbedRecord> records = perturb_trials(bundle, plan, folder, progress);
  std::set<std::string> replaced{"manifest.json"};
  ListDigest digests;
  for (std::size_t i = 0; i < records.size(); ++i) {
    replaced.insert(records[i].sources.begin(), records[i].sources.end());
    digests.add(bundle.trials[i].trial_id, records[i].digest);
  }
  if (faults.any()) {
    folder.write(kInjectionsFile, injections_text(bundle, records));
    replaced.insert(kInjectionsFile);
  }
  copy_others(bundle.path, replaced, folder);
  Manifest manifest;
  manifest.command = "assure";
  record(written(request), manifest);
  manifest.seed = plan.seed;
  manifest.synthetic = synthetic_label(bundle.info);
  manifest.inputs = bundle_inputs(bundle, digests.finish());
  folder.commit(std::move(manifest));
  return conclude_perturbing(request, bundle, records, progress);
}

}  // namespace tcert::cli
