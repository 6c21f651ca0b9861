#include <algorithm>
#include <terrain/lipschitz.hpp>
#include <terrain/model_choices.hpp>

namespace tcert::terrain {
namespace {

[[nodiscard]] FieldAssumptions assumptions_of(const ExploreSetup& setup, double length_scale) {
  return {length_scale, setup.noise_sd, setup.confidence, setup.gradient};
}

/// Half the 95 % point of chi-square with one degree of freedom: a length scale whose likelihood is
/// less likely by more is rejected.
constexpr double kLikelihoodRatio = 0.5 * 3.841458820694124;

}  // namespace

ModelChoices::ModelChoices(const ExploreSetup& setup) : setup_(setup) {
  const bool needs_scale = setup.rules.kind == RuleSet::band ||
                           (setup.rules.kind == RuleSet::certified && setup.confidence > 0.0);
  if (needs_scale) {
    scale_.emplace(assumptions_of(setup, setup.prior.length_scale));
  }
}

void ModelChoices::renew(Planner& planner) {
  const std::size_t n = planner.measurements().size();
  if (setup_.adaptive.on && n >= next_choice_) {
    next_choice_ = std::max(setup_.adaptive.first, 2 * n);
    if (n >= setup_.adaptive.first) {
      choose_length_scale(planner);
    }
  }
  if (!scale_) {
    return;
  }
  for (; taken_ < n; ++taken_) {
    scale_->add(planner.measurements()[taken_]);
  }
  if (scale_->renew()) {
    apply_scale(planner);
  }
}

void ModelChoices::apply_scale(Planner& planner) const {
  if (setup_.rules.kind == RuleSet::band) {
    planner.set_field_variance(scale_->variance_bound());
  } else if (scale_->variance_bound() < kUnbounded) {
    planner.set_lipschitz(scale_->lipschitz_bound(planner.grid()));
    if (setup_.prior_follows_lipschitz) {
      GpPrior prior = planner.model().prior();
      prior.variance = variance_of(planner.grid(), planner.rules().lipschitz, prior.length_scale);
      if (prior != planner.model().prior()) {
        planner.change_prior(prior);
      }
    }
  }
}

void ModelChoices::choose_length_scale(Planner& planner) {
  const bool is_band = setup_.rules.kind == RuleSet::band;
  const auto likelihood_of = [&](const GpPrior& prior) {
    return is_band ? profile_log_likelihood(prior, planner.measurements())
                   : log_likelihood(prior, planner.measurements());
  };
  GpPrior best = planner.model().prior();
  double highest = is_band ? likelihood_of(best) : planner.model().log_likelihood();
  std::vector<std::pair<GpPrior, double>> all{{best, highest}};
  for (const double factor : setup_.adaptive.factors) {
    GpPrior prior = setup_.prior;
    prior.length_scale *= factor;
    if (is_band) {
      prior.noise_variance = planner.model().prior().noise_variance;  // Its share, of --noise-sd.
    }
    all.emplace_back(prior, likelihood_of(prior));
    if (all.back().second > highest) {
      highest = all.back().second;
      best = prior;
    }
  }
  if (is_band) {
    // What certifies must not be too long: the shortest one that is not rejected.
    for (const auto& [prior, likelihood] : all) {
      if (likelihood >= highest - kLikelihoodRatio && prior.length_scale < best.length_scale) {
        best = prior;
      }
    }
  }
  if (best == planner.model().prior()) {
    return;
  }
  planner.change_prior(best);
  if (scale_) {
    scale_.emplace(assumptions_of(setup_, best.length_scale));
    taken_ = 0;
  }
  if (is_band) {
    planner.set_field_variance(kUnbounded);  // The bound was of another length scale.
  }
}

}  // namespace tcert::terrain
