#pragma once
/// \file
/// The commands of the tool; each one lives in the file of its name.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/commands/command_form.hpp"

namespace tcert::cli {

using Arguments = std::span<const std::string>;

struct Command {
  std::string_view name;
  std::string_view summary;  ///< One line.
  /// Arguments without the command's name. Returns the exit code; throws the errors of errors.hpp.
  int (*run)(Arguments arguments);
  /// Itself, then what it is with a word behind it.
  std::vector<CommandForm> (*forms)();
};

extern const Command kSimulate;
extern const Command kDrive;
extern const Command kImport;
extern const Command kCalibrate;
extern const Command kCheck;
extern const Command kCertify;
extern const Command kWorld;
extern const Command kFit;
extern const Command kHypotheses;
extern const Command kAblate;
extern const Command kSweep;
extern const Command kReplay;
extern const Command kFederate;
extern const Command kExplore;
extern const Command kGate;
extern const Command kAssure;
extern const Command kStudy;
extern const Command kBatch;
extern const Command kReport;
extern const Command kReproduce;
extern const Command kFigures;
extern const Command kVerify;
extern const Command kLive;
extern const Command kHelp;
extern const Command kVersion;

/// All of them, in the order of the data's way.
[[nodiscard]] std::span<const Command* const> commands();

}  // namespace tcert::cli
