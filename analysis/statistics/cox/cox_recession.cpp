#include <statistics/cox/cox_recession.hpp>

#include <algorithm>
#include <queue>
#include <statistics/logistic/cone_projection.hpp>
#include <utility>
#include <vector>

namespace tcert::statistics {
namespace {

constexpr double kPairTie = 1e-9;
constexpr double kSame = 1e-10;  ///< Rows as near to each other, of the widest row, are equal.
constexpr std::size_t kPairsAtOnce = 20;
constexpr int kRounds = 2000;

/// A row with an event that lies behind a row at risk, in the coordinates of the basis.
struct Violation {
  double size = 0.0;  ///< Of the distance of the two.
  Eigen::VectorXd difference;
};

/// Finds violated pairs.
class PairScan {
 public:
  PairScan(const CoxRows& rows, Ties ties, const Eigen::MatrixXd& basis)
      : rows_(rows), ties_(ties), basis_(basis), along_(rows.rows()) {
    for (std::size_t place = 0; place < rows.rows(); ++place) {
      widest_ = std::max(widest_, coordinates(place).norm());
    }
  }

  /// At each event time the worst pair along `direction`, a unit vector of the basis.
  std::vector<Violation> violations(const Eigen::VectorXd& direction) {
    const Eigen::VectorXd d = basis_ * direction;
    for (std::size_t place = 0; place < along_.size(); ++place) {
      along_[place] = row(place).dot(d);
    }
    std::vector<Violation> found;
    const RiskSets& sets = rows_.sets;
    for (std::size_t s = 0; s < sets.strata(); ++s) {
      at_risk_ = {};
      for (std::size_t t = sets.stratum_begin[s + 1]; t-- > sets.stratum_begin[s];) {
        visit(t, found);
      }
    }
    std::stable_sort(found.begin(), found.end(), [](const Violation& a, const Violation& b) {
      return a.size > b.size;
    });
    return found;
  }

 private:
  [[nodiscard]] Eigen::Map<const Eigen::VectorXd> row(std::size_t place) const {
    return {rows_.row(place), basis_.rows()};
  }
  [[nodiscard]] Eigen::VectorXd coordinates(std::size_t place) const {
    return basis_.transpose() * row(place);
  }

  void enter(std::size_t begin, std::size_t end) {
    for (std::size_t place = begin; place < end; ++place) {
      at_risk_.emplace(along_[place], static_cast<std::uint32_t>(place));
    }
  }

  void visit(std::size_t t, std::vector<Violation>& found) {
    const RiskSets& sets = rows_.sets;
    const std::size_t events = sets.events_begin[t];
    enter(sets.begin[t], ties_ == Ties::exact ? events : sets.begin[t + 1]);
    // A row that has not yet entered is dropped when it comes to the top.
    while (!at_risk_.empty() && sets.first[sets.order[at_risk_.top().second]] > t) {
      at_risk_.pop();
    }
    if (!at_risk_.empty()) {
      std::size_t last = events;
      for (std::size_t place = events; place < sets.begin[t + 1]; ++place) {
        last = along_[place] < along_[last] ? place : last;
      }
      add(last, at_risk_.top().second, found);
    }
    if (ties_ == Ties::exact) {
      enter(events, sets.begin[t + 1]);
    }
  }

  void add(std::size_t event, std::size_t other, std::vector<Violation>& found) const {
    const double size = along_[other] - along_[event];
    if (!(size > 0.0)) {
      return;
    }
    const Eigen::VectorXd difference = basis_.transpose() * (row(event) - row(other));
    const double distance = difference.norm();
    if (distance > kSame * widest_ && size > kPairTie * distance) {
      found.push_back({size / distance, difference / distance});
    }
  }

  const CoxRows& rows_;
  Ties ties_;
  const Eigen::MatrixXd& basis_;
  std::vector<double> along_;
  std::priority_queue<std::pair<double, std::uint32_t>> at_risk_;
  double widest_ = 0.0;
};

}  // namespace

std::optional<Eigen::VectorXd> recession_direction(const CoxRows& rows,
                                                   Ties ties,
                                                   const Eigen::MatrixXd& basis,
                                                   const Eigen::VectorXd& score) {
  const double length = score.norm();
  if (!(length > 0.0)) {
    return std::nullopt;
  }
  const Eigen::VectorXd target = score / length;
  PairScan scan(rows, ties, basis);
  ConeProjection projection(target);
  Eigen::MatrixXd pairs(0, target.size());
  for (int round = 0; round < kRounds; ++round) {
    const auto nearest = projection.onto(pairs, kPairTie);
    if (!nearest || nearest->isZero(0.0)) {
      return std::nullopt;
    }
    const std::vector<Violation> violations = scan.violations(nearest->normalized());
    if (violations.empty()) {
      return basis * *nearest;
    }
    const std::size_t added = std::min(violations.size(), kPairsAtOnce);
    Eigen::Index at = pairs.rows();
    pairs.conservativeResize(at + static_cast<Eigen::Index>(added), Eigen::NoChange);
    for (std::size_t k = 0; k < added; ++k) {
      pairs.row(at++) = violations[k].difference.transpose();
    }
  }
  return std::nullopt;
}

}  // namespace tcert::statistics
