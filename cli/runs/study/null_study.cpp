#include <memory>

#include "analysis/study/h1/hypothesis_h1.hpp"
#include "cli/runs/certify_trials.hpp"
#include "cli/runs/feature_data.hpp"
#include "cli/runs/h1_options.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/scratch_folder.hpp"
#include "cli/runs/simulate.hpp"
#include "cli/runs/study/studies.hpp"
#include "reports/study/coverage_report.hpp"

namespace tcert::cli {
namespace {

constexpr std::int64_t kCorpora = 40;

/// H1 of the corpus of this seed, in which the outcome has nothing to do with the margin.
std::vector<NullAuc> aucs_of(std::int64_t seed, std::int64_t threads, Progress& progress) {
  const ScratchFolder scratch;
  SimulateRequest corpus;
  corpus.effect = 0.0;
  corpus.seed = seed;
  corpus.threads = threads;
  corpus.output.path = (scratch.path() / "corpus").string();
  static_cast<void>(simulate(corpus, progress));
  const OpenedBundle opened = open_for(corpus.output.path, LogOptions{}, progress);
  FeatureData features(opened.bundle);
  static_cast<void>(
      certify_trials(opened, threads, progress, nullptr, {}, [&](study::TrialRecord&& trial) {
        features.add(trial);
      }));
  const study::H1Table tested =
      study::hypothesis_h1(features.table(), h1_options(HypothesesRequest{}));
  std::vector<NullAuc> rows;
  for (const study::H1Panel& panel : tested.panels) {
    const study::H1Score& auc = panel.rows.front().auc;
    rows.push_back({static_cast<std::uint64_t>(seed), panel.kind, auc.value, auc.interval});
  }
  return rows;
}

}  // namespace

StudyItems null_study(const StudyRequest& request, Progress& progress) {
  const auto rows = std::make_shared<std::vector<NullAuc>>();
  const auto make =
      [seed = request.seed, threads = request.threads, &progress](
          std::uint64_t first, std::uint64_t last, const std::function<void()>& /*done*/) {
        OnlyWords words(progress);
        std::vector<std::string> lines;
        for (std::uint64_t corpus = first; corpus < last; ++corpus) {
          lines.push_back(
              table::row_text(aucs_of(seed + static_cast<std::int64_t>(corpus), threads, words)));
        }
        return lines;
      };
  StudyItems items;
  items.sets.push_back(
      {"corpora", static_cast<std::uint64_t>(request.data_sets.value_or(kCorpora)), 1, make});
  items.take = [rows](std::size_t /*set*/, std::uint64_t /*corpus*/, std::string_view line) {
    const auto some = table::from_row<std::vector<NullAuc>>(line);
    rows->insert(rows->end(), some.begin(), some.end());
  };
  items.report = [rows] { return null_report(*rows); };
  return items;
}

}  // namespace tcert::cli
