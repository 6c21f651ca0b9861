#include "analysis/study/experiment/study_cells.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <tcert/certifier.hpp>
#include <utility>

#include "analysis/study/experiment/fingerprint.hpp"
#include "datasets/tick_limit.hpp"

namespace tcert::study {
namespace {

/// A set with what its steps depend on.
struct Step {
  const ParameterSet* set = nullptr;
  Robot robot;
  std::string resample, certify, features;
  std::size_t certifier = 0;  ///< Which certifier it uses: sets that agree in `certify` share one.
};

std::vector<Step> steps_of(const Bundle& bundle, std::span<const ParameterSet> sets) {
  std::vector<Step> steps;
  std::size_t certifiers = 0;
  for (const ParameterSet& set : sets) {
    validate(set);
    Step step{&set,
              with_overrides(bundle.info.robot, set.robot),
              fingerprint(set, Stage::resample),
              fingerprint(set, Stage::certify),
              fingerprint(set, Stage::features),
              certifiers};
    if (!steps.empty()) {
      step.certifier = steps.back().certifier + (steps.back().certify == step.certify ? 0 : 1);
    }
    // Made here once so that parameters out of range are reported before any trial is read.
    (void)Certifier(step.robot, bundle.info.course, set.certificate);
    steps.push_back(std::move(step));
  }
  return steps;
}

/// The certifiers of one thread, each made when it is first used.
class Certifiers {
 public:
  Certifiers(const Bundle& bundle, std::size_t count) : bundle_(&bundle), made_(count) {}

  Certifier& of(const Step& step) {
    std::unique_ptr<Certifier>& certifier = made_[step.certifier];
    if (!certifier) {
      certifier =
          std::make_unique<Certifier>(step.robot, bundle_->info.course, step.set->certificate);
    }
    return *certifier;
  }

 private:
  const Bundle* bundle_;
  std::vector<std::unique_ptr<Certifier>> made_;
};

void count(ReuseCount& counter, bool again) { ++(again ? counter.reused : counter.done); }

void add(ReuseCount& sum, const ReuseCount& part) {
  sum.done += part.done;
  sum.reused += part.reused;
}

/// The trial under every step, in order; each keeps what it can of the step before.
std::vector<std::string> texts_of(StudiedTrial& trial,
                                  const TrialLog& log,
                                  std::span<const Step> steps,
                                  Certifiers& certifiers,
                                  const TrialText& text,
                                  CellReuse& reuse) {
  std::vector<std::string> texts;
  const Step* last = nullptr;
  for (const Step& step : steps) {
    const bool same_ticks = last != nullptr && last->resample == step.resample;
    const bool same_series = same_ticks && last->certify == step.certify;
    const bool same_features = same_series && last->features == step.features;
    if (!same_ticks) {
      trial.ticks = resample(log, step.set->resample);
    }
    if (!same_series) {
      trial.series = certify_trial(certifiers.of(step), trial.ticks);
    }
    if (!same_features) {
      trial.features =
          early_features(step.robot, trial.ticks, trial.series.ticks, step.set->early_window);
    }
    count(reuse.resample, same_ticks);
    count(reuse.certify, same_series);
    count(reuse.features, same_features);
    texts.push_back(text(trial, texts.size()));
    last = &step;
  }
  return texts;
}

}  // namespace

CellReuse study_cells(const Bundle& bundle,
                      std::span<const std::size_t> trials,
                      std::span<const ParameterSet> sets,
                      const StudyOptions& options,
                      const TrialText& text,
                      const std::function<void(CellTrial&&)>& take) {
  const std::vector<Step> steps = steps_of(bundle, sets);
  if (steps.empty()) {
    return {};
  }
  // A trial is read for all cells or for none.
  double finest_s = sets.front().resample.tick_s;
  for (const ParameterSet& set : sets) {
    finest_s = std::min(finest_s, set.resample.tick_s);
  }
  tbb::enumerable_thread_specific<Certifiers> certifiers(
      [&] { return Certifiers(bundle, steps.back().certifier + 1); });
  CellReuse total;
  in_order(trials.size(), options.threads, [&](std::size_t i) {
    StudiedTrial trial;
    std::optional<TrialLog> log = read_studied(bundle, bundle.trials[trials[i]], options, trial);
    reject_too_many_ticks(log, finest_s, trial.row->trial_id, trial.diagnostics);
    trial.rejected = !log;
    auto done = std::make_shared<CellTrial>();
    auto reuse = std::make_shared<CellReuse>();
    done->row = trial.row;
    done->diagnostics = std::move(trial.diagnostics);
    done->rejected = trial.rejected;
    if (log) {
      reuse->read = {1, steps.size() - 1};
      done->texts = texts_of(trial, *log, steps, certifiers.local(), text, *reuse);
    }
    return std::function<bool()>([&total, &take, done, reuse] {
      add(total.read, reuse->read);
      add(total.resample, reuse->resample);
      add(total.certify, reuse->certify);
      add(total.features, reuse->features);
      take(std::move(*done));
      return true;
    });
  });
  return total;
}

}  // namespace tcert::study
