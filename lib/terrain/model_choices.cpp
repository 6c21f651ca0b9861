#include <algorithm>
#include <terrain/lipschitz.hpp>
#include <terrain/model_choices.hpp>

namespace tcert::terrain {

void ModelChoices::renew(Planner& planner) {
  const std::size_t n = planner.measurements().size();
  if (n < next_choice_) {
    return;
  }
  next_choice_ = std::max(setup_.adaptive.first, 2 * n);
  if (setup_.lipschitz_confidence > 0.0) {
    estimate_lipschitz_anew(planner);
  }
  if (setup_.adaptive.on && n >= setup_.adaptive.first) {
    choose_length_scale(planner);
  }
}

/// Raises the Lipschitz constant where the measurements ask for it. Never lowers it: where they
/// were taken depends on what was measured before. Without a further place nothing new is known,
/// and no risk is taken.
void ModelChoices::estimate_lipschitz_anew(Planner& planner) {
  const double confidence = confidence_of_estimate(setup_.lipschitz_confidence, estimates_ + 1);
  const LipschitzEstimate estimate = estimate_lipschitz(planner.grid(),
                                                        planner.measurements(),
                                                        planner.model().prior().length_scale,
                                                        setup_.rules.noise_bound,
                                                        confidence);
  if (estimate.patches <= patches_) {
    return;
  }
  ++estimates_;
  patches_ = estimate.patches;
  if (estimate.constant > planner.rules().lipschitz) {
    planner.set_lipschitz(estimate.constant);
  }
}

void ModelChoices::choose_length_scale(Planner& planner) const {
  GpPrior best = planner.model().prior();
  double highest = planner.model().log_likelihood();
  for (const double factor : setup_.adaptive.factors) {
    GpPrior prior = setup_.prior;
    prior.length_scale *= factor;
    const double likelihood = log_likelihood(prior, planner.measurements());
    if (likelihood > highest) {
      highest = likelihood;
      best = prior;
    }
  }
  if (best != planner.model().prior()) {
    planner.change_prior(best);
  }
}

}  // namespace tcert::terrain
