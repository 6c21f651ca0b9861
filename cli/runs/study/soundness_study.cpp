#include <algorithm>
#include <memory>
#include <span>
#include <utility>

#include "cli/runs/data_file.hpp"
#include "cli/runs/study/studies.hpp"
#include "reports/study/soundness_report.hpp"

namespace tcert::cli {
namespace {

using Methods = std::vector<study::SoundnessMethod>;

/// "A2" of "A2 (unknown=free)".
std::string word_of(const study::SoundnessMethod& method) {
  return method.name.substr(0, method.name.find_first_of(" ,"));
}

/// Those that are asked for. \throws UsageError.
class Wanted {
 public:
  explicit Wanted(const StudyRequest& request)
      : words_(words_of(request.methods)), readings_(request.readings) {
    if (readings_ != "exact" && readings_ != "noisy" && readings_ != "both") {
      throw UsageError("--readings: found '" + readings_ + "', expected exact, noisy or both");
    }
    std::vector<std::string> known;
    for (const Methods& some :
         {study::mixed_methods(), study::u_turn_methods(), study::witness_methods()}) {
      for (const study::SoundnessMethod& method : some) {
        known.push_back(word_of(method));
      }
    }
    for (const std::string& word : words_) {
      if (std::ranges::find(known, word) == known.end()) {
        throw UsageError("--methods: found '" + word +
                         "', expected radial, width, swept, A2, A3 or witness" +
                         did_you_mean(word, known));
      }
    }
  }

  [[nodiscard]] Methods of(Methods methods) const {
    std::erase_if(methods, [&](const study::SoundnessMethod& method) {
      const bool is_asked =
          words_.empty() || std::ranges::find(words_, word_of(method)) != words_.end();
      return !is_asked || (readings_ != "both" && method.noise != (readings_ == "noisy"));
    });
    return methods;
  }

 private:
  std::vector<std::string> words_;
  std::string readings_;
};

}  // namespace

StudyItems soundness_study(const StudyRequest& request, Progress& /*progress*/) {
  const auto runs = std::make_shared<SoundnessRuns>();
  study::SoundnessOptions options;
  options.seed = static_cast<std::uint64_t>(request.seed);
  runs->seed = options.seed;
  StudyItems items;
  const Wanted wanted(request);
  const auto add = [&](const char* name,
                       std::int64_t worlds,
                       WorldFamily (*family)(std::uint64_t),
                       std::span<const WorldFamily> families,
                       std::vector<study::SoundnessMethod> methods) {
    methods = wanted.of(request.witness ? study::witness_methods(request.reading_bound_m)
                                        : std::move(methods));
    if (methods.empty()) {
      return;
    }
    options.family = family;
    runs->kinds.push_back({name, {families.begin(), families.end()}, methods});
    items.sets.push_back(
        independent_items(std::string(name) + " worlds",
                          static_cast<std::uint64_t>(worlds),
                          [methods = std::move(methods), options](std::uint64_t world) {
                            return table::row_text(study::study_world(methods, options, world));
                          }));
  };
  add("mixed", request.worlds, mixed_family, kMixedFamilies, study::mixed_methods());
  add("hard", request.hard, hard_family, kHardFamilies, study::mixed_methods());
  add("u_turn", request.u_turns, u_turn_family, {}, study::u_turn_methods());
  if (request.driven > 0) {
    options.driven = true;
    add("driven", request.driven, mixed_family, {}, study::mixed_methods());
  }
  if (items.sets.empty()) {
    throw UsageError("--methods: no world is studied by " + request.methods);
  }
  items.take = [runs](std::size_t set, std::uint64_t number, std::string_view line) {
    SoundnessWorlds& kind = runs->kinds.at(set);
    const auto world = table::from_row<study::WorldOutcome>(line);
    if (world.outcomes.size() != kind.methods.size()) {
      throw table::RowError("found another number of methods");
    }
    kind.tally.add(world, number);
  };
  items.report = [runs] { return soundness_report(*runs); };
  return items;
}

}  // namespace tcert::cli
