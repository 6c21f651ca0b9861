#pragma once
/// \file
/// What a manifest says of a request: nothing but the request goes into it.

#include <string>
#include <vector>

#include "cli/runs/option_table.hpp"
#include "reports/manifest.hpp"

namespace tcert::cli {

struct WrittenOptions {
  Settings options;                         ///< Those that shape the result, and inputs.
  std::vector<ManifestArgument> arguments;  ///< A command line that gives the same result.
};

/// \param usual the table of a request as it is unless given.
[[nodiscard]] WrittenOptions written_options(const OptionTable& table, const OptionTable& usual);

/// An option is an argument if it was given or is not what it is unless given.
template <class Request>
[[nodiscard]] WrittenOptions written(Request request) {
  Request usual;
  return written_options(options_of(request), options_of(usual));
}

/// Options and arguments, into the manifest.
void record(WrittenOptions written, Manifest& manifest);

}  // namespace tcert::cli
