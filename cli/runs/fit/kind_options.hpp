#pragma once
/// \file
/// What each kind of fit takes: options, parts of a formula, and the tables that it gives.

#include <statistics/model/formula.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace tcert::cli {

/// True unless the option is another kind's. Options that no kind claims are for all.
[[nodiscard]] bool takes_option(std::string_view kind, std::string_view option);

/// \throws UsageError for an option or a part of the formula that would do nothing.
void require_taken(const std::string& kind,
                   const std::vector<std::string>& given,
                   const statistics::Formula& formula);

/// The names that --table takes, a line for one kind, a line each if `kind` is empty.
[[nodiscard]] std::string tables_in_words(std::string_view kind);

[[nodiscard]] std::vector<std::string> kind_names();

}  // namespace tcert::cli
