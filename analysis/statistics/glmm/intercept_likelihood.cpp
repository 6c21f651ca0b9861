#include <statistics/glmm/intercept_likelihood.hpp>

#include <tbb/parallel_for.h>

#include <cmath>
#include <statistics/glmm/intercept_mode.hpp>

namespace tcert::statistics {
namespace {

constexpr Eigen::Index kBlockRows = 2048;
constexpr double kLargestFixed = 300.0;

/// What one thread needs for its blocks.
struct BlockRoom {
  Eigen::VectorXd fixed, odds, slope, curvature;
  RowMajorMatrix bent;
  InterceptScratch scratch;
};

BlockRoom& room_of_thread() {
  static thread_local BlockRoom room;
  return room;
}

void make_room(Eigen::Index size, BlockRoom& room) {
  if (room.fixed.size() < size) {
    for (auto* list : {&room.fixed, &room.odds, &room.slope, &room.curvature}) {
      list->resize(size);
    }
  }
}

}  // namespace

InterceptLikelihood::InterceptLikelihood(const GroupedRows& rows, int quadrature)
    : rows_(rows),
      rule_(hermite_rule(quadrature)),
      modes_(static_cast<std::size_t>(rows.groups()), 0.0) {
  Block block;
  while (block.last < rows_.groups()) {
    ++block.last;
    const Eigen::Index size = rows_.start[static_cast<std::size_t>(block.last)] -
                              rows_.start[static_cast<std::size_t>(block.first)];
    if (size >= kBlockRows || block.last == rows_.groups()) {
      blocks_.push_back(block);
      block.first = block.last;
    }
  }
}

InterceptGroup InterceptLikelihood::group(Eigen::Index index,
                                          const double* fixed,
                                          const double* odds) const {
  const Eigen::Index start = rows_.start[static_cast<std::size_t>(index)];
  InterceptGroup group;
  group.basis = rows_.basis.data() + start * rows_.basis.cols();
  group.successes = rows_.successes.data() + start;
  group.trials = rows_.trials.data() + start;
  group.fixed = fixed;
  group.odds = odds;
  group.rows = rows_.start[static_cast<std::size_t>(index) + 1] - start;
  group.columns = rows_.basis.cols();
  group.unit_trials = rows_.unit_trials;
  return group;
}

void InterceptLikelihood::add_block(const Eigen::VectorXd& parameters,
                                    Derivatives wanted,
                                    Block& block) {
  const Eigen::Index columns = rows_.basis.cols();
  const Eigen::Index start = rows_.start[static_cast<std::size_t>(block.first)];
  const Eigen::Index size = rows_.start[static_cast<std::size_t>(block.last)] - start;
  BlockRoom& room = room_of_thread();
  make_room(size, room);
  const auto basis = rows_.basis.middleRows(start, size);
  auto fixed = room.fixed.head(size);
  fixed.noalias() = basis * parameters.tail(columns);
  if (rows_.offset.size() > 0) {
    fixed += rows_.offset.segment(start, size);
  }
  block.sum.value = 0.0;
  block.sum.gradient.setZero(1 + columns);
  if (wanted == Derivatives::hessian) {
    block.sum.hessian.setZero(1 + columns, 1 + columns);
  }
  block.possible = fixed.cwiseAbs().maxCoeff() <= kLargestFixed;
  if (!block.possible) {
    return;
  }
  room.odds.head(size) = fixed.array().exp();
  for (Eigen::Index g = block.first; g < block.last && block.possible; ++g) {
    const Eigen::Index at = rows_.start[static_cast<std::size_t>(g)] - start;
    block.possible = add_intercept_group(group(g, room.fixed.data() + at, room.odds.data() + at),
                                         parameters[0],
                                         rule_,
                                         wanted,
                                         modes_[static_cast<std::size_t>(g)],
                                         room.scratch,
                                         room.slope.data() + at,
                                         room.curvature.data() + at,
                                         block.sum);
  }
  if (!block.possible || wanted == Derivatives::none) {
    return;
  }
  block.sum.gradient.tail(columns).noalias() += basis.transpose() * room.slope.head(size);
  if (wanted == Derivatives::hessian) {
    room.bent = room.curvature.head(size).asDiagonal() * basis;
    block.sum.hessian.bottomRightCorner(columns, columns).noalias() +=
        basis.transpose() * room.bent;
  }
}

bool InterceptLikelihood::evaluate(const Eigen::VectorXd& parameters,
                                   Derivatives wanted,
                                   LikelihoodPoint& point) {
  if (!parameters.allFinite()) {
    return false;
  }
  if (blocks_.size() == 1) {
    add_block(parameters, wanted, blocks_.front());
  } else {
    tbb::parallel_for(std::size_t{0}, blocks_.size(), [&](std::size_t b) {
      add_block(parameters, wanted, blocks_[b]);
    });
  }
  point.value = 0.0;
  point.gradient.setZero(size());
  point.hessian.setZero(wanted == Derivatives::hessian ? size() : 0,
                        wanted == Derivatives::hessian ? size() : 0);
  for (const Block& block : blocks_) {
    if (!block.possible) {
      return false;
    }
    point.value += block.sum.value;
    point.gradient += block.sum.gradient;
    if (wanted == Derivatives::hessian) {
      point.hessian += block.sum.hessian;
    }
  }
  if (wanted == Derivatives::hessian) {
    point.hessian.triangularView<Eigen::StrictlyUpper>() = point.hessian.transpose();
  }
  return std::isfinite(point.value);
}

std::vector<TermModes> InterceptLikelihood::modes(const Eigen::VectorXd& parameters) {
  LikelihoodPoint point;
  std::vector<TermModes> result(1);
  result[0].modes.resize(rows_.groups(), 1);
  result[0].sds.resize(rows_.groups(), 1);
  if (!evaluate(parameters, Derivatives::none, point)) {
    result[0].modes.setConstant(std::nan(""));
    result[0].sds.setConstant(std::nan(""));
    return result;
  }
  const double theta = parameters[0];
  Eigen::VectorXd fixed = rows_.basis * parameters.tail(rows_.basis.cols());
  if (rows_.offset.size() > 0) {
    fixed += rows_.offset;
  }
  const Eigen::VectorXd odds = fixed.array().exp();
  for (Eigen::Index g = 0; g < rows_.groups(); ++g) {
    const Eigen::Index start = rows_.start[static_cast<std::size_t>(g)];
    const double u = modes_[static_cast<std::size_t>(g)];
    const double h =
        intercept_curvature(group(g, fixed.data() + start, odds.data() + start), theta, u);
    result[0].modes(g, 0) = theta * u;
    result[0].sds(g, 0) = std::abs(theta) / std::sqrt(h);
  }
  return result;
}

}  // namespace tcert::statistics
