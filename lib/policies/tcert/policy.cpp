#include <algorithm>
#include <array>
#include <tcert/policy.hpp>
#include <type_traits>

namespace tcert::policies {
namespace {

constexpr std::array<std::string_view, kPolicies> kNames{
    "M1", "M2", "M3", "TVFH", "TD*Lite", "CB-V"};

/// Calls visit(policy) of the one that the variant holds. A variant of types that move without
/// exceptions always holds one, so that unlike std::visit this has nothing to throw.
template <std::size_t I = 0, typename Any, typename Visit>
decltype(auto) with_policy(Any& any, Visit visit) noexcept {
  if constexpr (I + 1 < kPolicies) {
    if (std::get_if<I>(&any) == nullptr) {
      return with_policy<I + 1>(any, visit);
    }
  }
  return visit(*std::get_if<I>(&any));
}

}  // namespace

std::string_view name_of(PolicyKind kind) noexcept {
  return kNames[static_cast<std::size_t>(kind)];
}

std::optional<PolicyKind> policy_named(std::string_view name) noexcept {
  const auto* const found = std::find(kNames.begin(), kNames.end(), name);
  return found == kNames.end() ? std::nullopt
                               : std::optional(static_cast<PolicyKind>(found - kNames.begin()));
}

Policy::Any Policy::make(PolicyKind kind, const PolicySetup& setup) {
  static_assert(std::is_nothrow_move_constructible_v<Any>);
  switch (kind) {
    case PolicyKind::m1:
      break;
    case PolicyKind::m2:
      return TerrainWeightedPolicy(setup);
    case PolicyKind::m3:
      return MemoryPolicy(setup);
    case PolicyKind::tvfh:
      return HistogramPolicy(setup);
    case PolicyKind::td_star_lite:
      return ReplanningPolicy(setup);
    case PolicyKind::cb_v:
      return CameraPolicy(setup);
  }
  return ReactivePolicy(setup);
}

Policy::Policy(PolicyKind kind, const PolicySetup& setup)
    : kind_(kind), policy_(make(kind, setup)) {}

Command Policy::step(const Senses& senses) noexcept {
  return with_policy(policy_, [&](auto& policy) noexcept { return policy.step(senses); });
}

void Policy::reset() noexcept {
  with_policy(policy_, [](auto& policy) noexcept { policy.reset(); });
}

void Policy::give_up_lane() noexcept {
  with_policy(policy_, [](auto& policy) noexcept { policy.pilot().give_up_lane(); });
}

const Pilot& Policy::pilot() const noexcept {
  return with_policy(policy_,
                     [](const auto& policy) noexcept -> const Pilot& { return policy.pilot(); });
}

std::uint32_t Policy::failed_recoveries() const noexcept { return pilot().recovery().failed(); }

const LineFollower& Policy::line() const noexcept { return pilot().line(); }

}  // namespace tcert::policies
