#include <algorithm>
#include <cmath>
#include <span>
#include <tcert/pending_pass.hpp>

namespace tcert {
namespace {

double quantile_of_sorted(std::span<const double> sorted, double share) noexcept {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  const double step = place - static_cast<double>(below);
  return sorted[below] + step * (sorted[above] - sorted[below]);
}

void summarise(std::span<double> samples, Profile& profile) noexcept {
  std::sort(samples.begin(), samples.end());
  profile.p05 = quantile_of_sorted(samples, 0.05);
  profile.p50 = quantile_of_sorted(samples, 0.50);
  profile.p95 = quantile_of_sorted(samples, 0.95);
}

}  // namespace

void PendingPass::restart(const Evidence& evidence) noexcept {
  pass_ = {};
  pass_.margin_m = std::numeric_limits<double>::infinity();
  pass_.width.min = pass_.turn_radius.min = std::numeric_limits<double>::infinity();
  pass_.width.max = pass_.turn_radius.max = -std::numeric_limits<double>::infinity();
  left_m_ = right_m_ = std::numeric_limits<double>::infinity();
  kept_ = 0;
  stride_ = 1;
  seen_ = 0;
  add(evidence);
}

void PendingPass::add(const Evidence& evidence) noexcept {
  if (evidence.margin_m < pass_.margin_m) {
    pass_.margin_m = evidence.margin_m;
    pass_.narrowest = evidence.pose;
    pass_.width_m = evidence.width_m;
    pass_.turn_radius_m = evidence.turn_radius_m;
  }
  left_m_ = std::min(left_m_, evidence.left_m);
  right_m_ = std::min(right_m_, evidence.right_m);
  pass_.width.min = std::min(pass_.width.min, evidence.width_m);
  pass_.width.max = std::max(pass_.width.max, evidence.width_m);
  pass_.turn_radius.min = std::min(pass_.turn_radius.min, evidence.turn_radius_m);
  pass_.turn_radius.max = std::max(pass_.turn_radius.max, evidence.turn_radius_m);
  if (seen_++ % stride_ == 0) {
    keep(evidence.width_m, evidence.turn_radius_m);
  }
}

void PendingPass::keep(double width_m, double turn_radius_m) noexcept {
  if (kept_ == kSamples) {
    for (std::size_t i = 0; i < kSamples / 2; ++i) {
      widths_m_[i] = widths_m_[2 * i];
      radii_m_[i] = radii_m_[2 * i];
    }
    kept_ = kSamples / 2;
    stride_ *= 2;
  }
  widths_m_[kept_] = width_m;
  radii_m_[kept_] = turn_radius_m;
  ++kept_;
}

Pass PendingPass::finish() noexcept {
  summarise(std::span(widths_m_).first(kept_), pass_.width);
  summarise(std::span(radii_m_).first(kept_), pass_.turn_radius);
  return pass_;
}

}  // namespace tcert
