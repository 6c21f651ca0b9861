#include "reports/version.hpp"

namespace tcert {

std::string_view tool_version() noexcept { return TCERT_VERSION; }
std::string_view tool_commit() noexcept { return TCERT_COMMIT; }

}  // namespace tcert
