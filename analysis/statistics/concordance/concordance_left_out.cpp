#include <algorithm>
#include <statistics/concordance/concordance_replicates.hpp>
#include <stdexcept>
#include <utility>

namespace tcert::statistics {

/// Of each row, the pairs that it is in, on whichever side; before `directed`.
std::vector<ConcordanceReplicates::Counts> ConcordanceReplicates::counts_of_rows() const {
  std::vector<Counts> of_row(rows_);
  Scratch scratch;
  scratch.reset(distinct_);
  for (const Visit& visit : visits_) {
    if (visit.step == Step::next_stratum) {
      scratch.reset(distinct_);
    } else if (visit.step == Step::compare) {
      of_row[visit.row] += scratch.against(visit.rank, 1);
    } else {
      scratch.add(visit.rank, visit.step == Step::enter ? 1U : 0U - 1U);
    }
  }
  // Backwards a row meets the events that it was at risk in: those since it entered, less those
  // since it left. Concordant are the events that rank below it.
  scratch.reset(distinct_);
  for (std::size_t k = visits_.size(); k-- > 0;) {
    const Visit& visit = visits_[k];
    if (visit.step == Step::next_stratum) {
      scratch.reset(distinct_);
    } else if (visit.step == Step::compare) {
      scratch.add(visit.rank, 1);
    } else {
      Counts met = scratch.against(visit.rank, 1);
      std::swap(met.concordant, met.discordant);
      visit.step == Step::enter ? of_row[visit.row] += met : of_row[visit.row] -= met;
    }
  }
  return of_row;
}

std::vector<std::vector<ConcordanceReplicates::Visit>> ConcordanceReplicates::visits_by_unit(
    const ResamplingPlan& plan) const {
  std::vector<std::vector<Visit>> of_unit(plan.units());
  for (const Visit& visit : visits_) {
    if (visit.step != Step::next_stratum) {
      of_unit[plan.unit_of(visit.row)].push_back(visit);
      continue;
    }
    for (std::vector<Visit>& visits : of_unit) {
      if (!visits.empty() && visits.back().step != Step::next_stratum) {
        visits.push_back(visit);
      }
    }
  }
  return of_unit;
}

/// The pairs whose rows are both of the unit; before `directed`.
std::vector<ConcordanceReplicates::Counts> ConcordanceReplicates::counts_within(
    const ResamplingPlan& plan) const {
  std::vector<Counts> within(plan.units());
  if (plan.units() == plan.rows()) {
    return within;
  }
  const std::vector<std::vector<Visit>> of_unit = visits_by_unit(plan);
  Scratch scratch;
  std::vector<std::uint32_t> ranks;
  for (std::size_t unit = 0; unit < within.size(); ++unit) {
    // Ranks of its own: the sums are then as small as the unit.
    ranks.clear();
    for (const Visit& visit : of_unit[unit]) {
      ranks.push_back(visit.rank);
    }
    std::sort(ranks.begin(), ranks.end());
    ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
    scratch.reset(ranks.size());
    for (const Visit& visit : of_unit[unit]) {
      const auto rank = static_cast<std::uint32_t>(
          std::lower_bound(ranks.begin(), ranks.end(), visit.rank) - ranks.begin());
      if (visit.step == Step::next_stratum) {
        scratch.reset(ranks.size());
      } else if (visit.step == Step::compare) {
        within[unit] += scratch.against(rank, 1);
      } else {
        scratch.add(rank, visit.step == Step::enter ? 1U : 0U - 1U);
      }
    }
  }
  return within;
}

std::vector<ConcordanceReplicates::Counts> ConcordanceReplicates::without_units(
    const ResamplingPlan& plan) const {
  if (plan.rows() != rows_) {
    throw std::invalid_argument("concordance: the plan is of other rows");
  }
  const std::vector<Counts> of_row = counts_of_rows();
  Counts twice_all;
  for (const Counts& one : of_row) {
    twice_all += one;
  }
  const Counts all{twice_all.concordant / 2, twice_all.discordant / 2, twice_all.tied_x / 2};
  // What goes with a unit are the pairs of its rows, those within it once.
  std::vector<Counts> left = counts_within(plan);
  for (Counts& one : left) {
    one += all;
  }
  for (std::size_t row = 0; row < rows_; ++row) {
    left[plan.unit_of(row)] -= of_row[row];
  }
  std::transform(
      left.begin(), left.end(), left.begin(), [&](const Counts& one) { return directed(one); });
  return left;
}

}  // namespace tcert::statistics
