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
void add_corpus(std::int64_t seed,
                std::int64_t threads,
                Progress& progress,
                std::vector<NullAuc>& rows) {
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
  for (const study::H1Panel& panel : tested.panels) {
    const study::H1Score& auc = panel.rows.front().auc;
    rows.push_back({static_cast<std::uint64_t>(seed),
                    std::string(study::to_string(panel.kind)),
                    auc.value,
                    auc.interval});
  }
}

}  // namespace

FitReport null_study(const StudyRequest& request, Progress& progress) {
  const std::int64_t corpora = request.data_sets.value_or(kCorpora);
  std::vector<NullAuc> rows;
  OnlyWords words(progress);
  Stage stage(progress, "corpora", static_cast<std::size_t>(corpora));
  for (std::int64_t i = 0; i < corpora; ++i) {
    add_corpus(request.seed + i, request.threads, words, rows);
    stage.advance();
  }
  return null_report(rows);
}

}  // namespace tcert::cli
