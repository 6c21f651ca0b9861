#include "analysis/study/driven/fitted_policies.hpp"

#include <array>
#include <cstddef>

namespace tcert::study {

const FittedPolicy& fitted_policy(policies::PolicyKind kind) noexcept {
  static const auto all = [] {
    std::array<FittedPolicy, policies::kPolicies> fitted;
#define TCERT_FITTED(kind, cruise, caution, lookahead) \
  fitted[static_cast<std::size_t>(policies::PolicyKind::kind)] = {cruise, caution, lookahead};
#include "analysis/study/driven/fitted_policies.def"
#undef TCERT_FITTED
    return fitted;
  }();
  return all[static_cast<std::size_t>(kind)];
}

}  // namespace tcert::study
