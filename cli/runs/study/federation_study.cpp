#include <memory>

#include "cli/runs/study/studies.hpp"
#include "reports/study/team_report.hpp"

namespace tcert::cli {

StudyItems federation_study(const StudyRequest& request, Progress& /*progress*/) {
  const auto worlds = std::make_shared<std::vector<study::FederationOutcome>>();
  const auto seed = static_cast<std::uint64_t>(request.seed);
  const std::int64_t count = is_given(request.given, "worlds") ? request.worlds : 2000;
  StudyItems items;
  items.sets = {
      independent_items("worlds", static_cast<std::uint64_t>(count), [seed](std::uint64_t world) {
        return table::row_text(study::federate_world(seed, world));
      })};
  items.take = [worlds](std::size_t /*set*/, std::uint64_t /*number*/, std::string_view line) {
    worlds->push_back(table::from_row<study::FederationOutcome>(line));
    if (worlds->back().teams.size() != study::kTeams.size() * study::kFederationMethods.size()) {
      throw table::RowError("found another number of teams");
    }
  };
  items.report = [worlds, seed] { return team_report(*worlds, seed); };
  return items;
}

}  // namespace tcert::cli
