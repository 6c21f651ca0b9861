#pragma once
/// \file
/// What an option is to a result, said where the option is declared: po::value() and
/// po::bool_switch() declare one that shapes the result.

#include <boost/program_options.hpp>
#include <cstdint>
#include <string>

namespace tcert::cli {

enum class OptionRole : std::uint8_t {
  shapes,   ///< The result: in the manifest, and again when it is verified.
  input,    ///< A file or folder that is read; in the manifest by its name.
  output,   ///< Where something is written: not what.
  process,  ///< How the result is made, which does not change it: threads, progress, caches.
};

/// Values of the other roles; the help shows them as `shown`: "FILE".
[[nodiscard]] boost::program_options::typed_value<std::string>* input(std::string& value,
                                                                      const char* shown);
[[nodiscard]] boost::program_options::typed_value<std::string>* output(std::string& value,
                                                                       const char* shown);
[[nodiscard]] boost::program_options::typed_value<std::int64_t>* process(std::int64_t& value,
                                                                         const char* shown);
[[nodiscard]] boost::program_options::typed_value<std::string>* process(std::string& value,
                                                                        const char* shown);
[[nodiscard]] boost::program_options::typed_value<bool>* process_switch(bool& value);

[[nodiscard]] OptionRole role_of(const boost::program_options::option_description& option);

}  // namespace tcert::cli
