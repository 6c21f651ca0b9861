#pragma once
/// \file
/// From the words that a manifest keeps of a command line back to the request: whoever wrote them
/// may be a stranger.

#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "cli/runs/option_table.hpp"
#include "reports/manifest.hpp"

namespace tcert::cli {

/// The manifest's command line is not one that this tool writes. The message says what is not.
class NotReproducible : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Where the input of that name lies; empty if it is not found, which the caller notes. The first
/// input that is no option's is told from others.
using FindInput = std::function<std::optional<std::string>(const std::string& name, bool first)>;

/// Of the options only those that shape what is made are let through (OptionRole): none that says
/// where something is written or kept, or how. Every word that names a file must be an input, by
/// its bare name: is_path_step(). An input that is not found is left out. \throws NotReproducible.
void read_request(const std::string& command,
                  const OptionTable& table,
                  std::span<const ManifestArgument> words,
                  const FindInput& find);

}  // namespace tcert::cli
