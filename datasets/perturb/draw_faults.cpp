#include "datasets/perturb/draw_faults.hpp"

#include <algorithm>
#include <cmath>
#include <table/random.hpp>
#include <tcert/elementary.hpp>
#include <tuple>

namespace tcert::perturb {
namespace {

constexpr std::uint32_t kPurpose = 0x7065'0000;
constexpr double kHourS = 3600.0;

/// FNV-1a of the name: a trial has its draws whatever stands beside it in the bundle.
std::uint64_t index_of_trial(std::string_view trial_id) noexcept {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : trial_id) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  }
  return hash;
}

class FaultDraws {
 public:
  explicit FaultDraws(const FaultDraw& draw)
      : draw_(draw), span_s_(1e-9 * static_cast<double>(draw.end_ns - draw.begin_ns)) {}

  void dropouts(double good_s, double bad_s) {
    table::RandomStream random = random_of(FaultKind::dropout);
    bool bad = random.uniform() < bad_s / (good_s + bad_s);
    for (double at_s = 0.0; at_s < span_s_; bad = !bad) {
      const double ends_s = at_s + exponential(random, bad ? bad_s : good_s);
      if (bad) {
        faults_.push_back({FaultKind::dropout,
                           {},
                           time_of(at_s),
                           ends_s < span_s_ ? time_of(ends_s) : draw_.end_ns});
      }
      at_s = ends_s;
    }
  }

  /// \pre `rays` is not empty for a kind of faults of a ray.
  void poisson(FaultKind kind,
               double per_hour,
               double length_s,
               double size,
               const std::vector<std::size_t>* rays) {
    if (per_hour <= 0.0 || (rays != nullptr && rays->empty())) {
      return;
    }
    table::RandomStream random = random_of(kind);
    double at_s = exponential(random, kHourS / per_hour);
    for (; at_s + length_s <= span_s_; at_s += exponential(random, kHourS / per_hour)) {
      Injection one{kind, {}, time_of(at_s), 0, size};
      one.end_ns = one.start_ns + std::llround(1e9 * length_s);
      if (rays != nullptr) {
        one.ray = (*rays)[random.below(static_cast<std::uint32_t>(rays->size()))];
      }
      if (one.end_ns <= draw_.end_ns) {
        faults_.push_back(one);
      }
    }
  }

  /// On one ray from the beginning of the trial to its end.
  void whole_trial(FaultKind kind, double size) {
    if (!draw_.rays.empty()) {
      table::RandomStream random = random_of(kind);
      const std::size_t ray =
          draw_.rays[random.below(static_cast<std::uint32_t>(draw_.rays.size()))];
      faults_.push_back({kind, ray, draw_.begin_ns, draw_.end_ns, size});
    }
  }

  std::vector<Injection> take() {
    std::ranges::stable_sort(faults_, {}, [](const Injection& one) {
      return std::tuple(one.start_ns, one.kind, one.ray);
    });
    return std::move(faults_);
  }

 private:
  [[nodiscard]] table::RandomStream random_of(FaultKind kind) const {
    const auto purpose = kPurpose + 16U * static_cast<std::uint32_t>(draw_.stream) +
                         static_cast<std::uint32_t>(kind);
    return {draw_.seed, purpose, index_of_trial(draw_.trial_id)};
  }

  static double exponential(table::RandomStream& random, double mean) {
    return -mean * elementary::log(random.uniform());
  }

  /// \pre at_s < span_s_.
  [[nodiscard]] std::int64_t time_of(double at_s) const {
    return draw_.begin_ns + std::llround(1e9 * at_s);
  }

  const FaultDraw& draw_;
  double span_s_;
  std::vector<Injection> faults_;
};

}  // namespace

std::vector<Injection> draw_faults(const FaultOptions& options, const FaultDraw& draw) {
  FaultDraws draws(draw);
  if (draw.has_links && options.dropout_good_s > 0.0) {
    draws.dropouts(options.dropout_good_s, options.dropout_bad_s);
  }
  if (draw.has_links) {
    draws.poisson(
        FaultKind::latency, options.bursts_per_hour, options.burst_s, options.burst_s, nullptr);
  }
  draws.poisson(FaultKind::spike,
                options.spikes_per_hour,
                options.spike_width_s,
                options.spike_n,
                &draw.feeling);
  draws.poisson(FaultKind::freeze, options.freezes_per_hour, options.freeze_s, 0.0, &draw.rays);
  draws.poisson(FaultKind::wide, options.wide_per_hour, options.wide_s, 0.0, &draw.rays);
  draws.poisson(
      FaultKind::bias, options.biases_per_hour, options.bias_s, options.bias_m, &draw.rays);
  if (options.bias_whole_trial) {
    draws.whole_trial(FaultKind::bias, options.bias_m);
  }
  return draws.take();
}

}  // namespace tcert::perturb
