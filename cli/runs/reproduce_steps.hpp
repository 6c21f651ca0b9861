#pragma once
/// \file
/// The runs of `reproduce`, one after the other, each into its folder. Internal to it.

#include <algorithm>
#include <filesystem>
#include <string>

#include "cli/runs/inputs.hpp"
#include "cli/runs/reproduce.hpp"
#include "cli/runs/result_folder.hpp"

namespace tcert::cli {

class Steps {
 public:
  Steps(const ReproduceRequest& request, Progress& progress)
      : request_(request), progress_(progress), parts_(progress), folder_(request.output.path) {}

  [[nodiscard]] std::filesystem::path at(const char* part) const { return folder_ / part; }

  /// A request for a part, told all that was told to this run.
  template <class Request>
  [[nodiscard]] Request of(const char* part) const {
    Request request;
    request.output.path = (folder_ / part / "").string();
    request.threads = request_.threads;
    if constexpr (requires { request.seed; }) {
      request.seed = request_.seed;
      request.given = {"seed"};  // Named in the manifest, whatever it is.
    }
    return request;
  }

  /// Likewise, for a run that reads the logs.
  template <class Request>
  [[nodiscard]] Request of_logs(const char* part, const std::string& bundle) const {
    auto request = of<Request>(part);
    request.bundle = bundle;
    request.logs = request_.logs;
    return request;
  }

  /// Must go well.
  template <class Request>
  void require(ExitCode (*run)(const Request&, Progress&), const Request& request) {
    const ExitCode code = run(request, parts_);
    if (code != exit_done && code != exit_rejected) {
      throw BadData("'" + request.output.path + "' could not be made");
    }
    note(code);
  }

  /// May be impossible with these data: it is left out then, and nothing of an earlier run stands
  /// for it.
  template <class Request>
  void attempt(const char* part,
               const char* command,
               ExitCode (*run)(const Request&, Progress&),
               const Request& request) {
    const auto leave_out = [&](const std::exception& error) {
      remove_own_folder(folder_ / part, command);
      progress_.say(std::string(part) + " is left out: " + error.what());
    };
    try {
      const ExitCode code = run(request, parts_);
      if (code == exit_bad_data) {
        progress_.say(std::string(part) +
                      " has no estimate, as said above; what there is stands in " +
                      (folder_ / part).string());
      } else {
        note(code);
      }
    } catch (const BadData& error) {
      leave_out(error);
    } catch (const UnfitData& error) {
      leave_out(error);
    }
  }

  [[nodiscard]] ExitCode code() const noexcept { return code_; }

 private:
  void note(ExitCode code) { code_ = std::max(code_, code); }

  const ReproduceRequest& request_;
  Progress& progress_;
  WithoutSums parts_;
  std::filesystem::path folder_;
  ExitCode code_ = exit_done;
};

/// Where the landmark of the features is, if not where it usually is.
[[nodiscard]] std::string landmark_of(const OpenedBundle& opened);

}  // namespace tcert::cli
