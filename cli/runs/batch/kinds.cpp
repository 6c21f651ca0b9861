#include "cli/runs/batch/kinds.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <type_traits>

namespace tcert::cli {
namespace {

using Words = std::span<const ManifestArgument>;

/// Parts are what is kept of a batch; tasks do not fill anybody's cache.
template <class Request>
Request by_itself(Request request, std::int64_t threads) {
  request.threads = threads;
  if constexpr (std::is_base_of_v<CellsRequest, Request>) {
    request.no_cache = true;
  }
  return request;
}

template <class Request, ExitCode (*run)(const Request&, Progress&, const ItemSource&)>
Pieces read(const std::string& command, Words words, const FindInput& find) {
  Request request;
  read_request(command, options_of(request), words, find);
  require_values(options_of(request));
  return {[request](std::int64_t threads, Progress& progress) {
            return items_of(by_itself(request, threads), progress);
          },
          [request](const std::string& output,
                    std::int64_t threads,
                    Progress& progress,
                    const ItemSource& source) {
            Request now = by_itself(request, threads);
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
