#pragma once
/// \file
/// The command line of a manifest, as far as a manifest may have one: whoever wrote it may be a
/// stranger.

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "reports/manifest_read.hpp"

namespace tcert::cli {

/// The command line is not one that this tool writes into a manifest. The message says what is not.
class NotReproducible : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct CommandWords {
  const Command* command = nullptr;
  std::vector<std::string> words;
};

/// Where the input of that name lies; empty if it is not found, which the caller notes. The first
/// input that is no option's is told from others.
using FindInput = std::function<std::optional<std::string>(const std::string& name, bool first)>;

/// The words with which the result of `manifest` is made again, without --output. Only the commands
/// that make results are let through, and of their options only those that shape what is made:
/// none that says where something else is written or kept (--output, --figures, --picture, --cache,
/// --audit, --record, --config of an ordinary command), by how many threads, or how much is said.
/// Every word that names a file must be an input, by its bare name: is_path_step(). An input that
/// is not found is left out. \throws NotReproducible.
[[nodiscard]] CommandWords command_words(const WrittenResult& manifest, const FindInput& find);

}  // namespace tcert::cli
