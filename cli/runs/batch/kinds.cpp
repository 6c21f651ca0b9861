#include "cli/runs/batch/kinds.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace tcert::cli {
namespace {

using Words = std::span<const ManifestArgument>;

template <class Request, ExitCode (*run)(const Request&, Progress&, const ItemSource&)>
Pieces read(const std::string& command, Words words, const FindInput& find) {
  Request request;
  read_request(command, options_of(request), words, find);
  require_values(options_of(request));
  return {[request](std::int64_t threads, Progress& progress) {
            Request now = request;
            now.threads = threads;
            return items_of(now, progress);
          },
          [request](const std::string& output,
                    std::int64_t threads,
                    Progress& progress,
                    const ItemSource& source) {
            Request now = request;
            now.threads = threads;
            now.output.path = output;
            return run(now, progress, source);
          }};
}

struct Kind {
  std::string_view command;
  Pieces (*read)(const std::string& command, Words words, const FindInput& find);
};

constexpr std::array kKinds{Kind{"ablate", read<AblateRequest, ablate>},
                            Kind{"sweep", read<SweepRequest, sweep>},
                            Kind{"study", read<StudyRequest, study>},
                            Kind{"simulate", read<SimulateRequest, simulated_features>},
                            Kind{"drive", read<DriveRequest, driven_features>}};

}  // namespace

Pieces pieces_of(const std::string& command, Words words, const FindInput& find) {
  const auto* const kind = std::ranges::find(kKinds, command, &Kind::command);
  if (kind == kKinds.end()) {
    throw NotReproducible("'" + command + "' is no command that works in pieces");
  }
  return kind->read(command, words, find);
}

}  // namespace tcert::cli
