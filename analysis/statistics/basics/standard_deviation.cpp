#include <statistics/basics/standard_deviation.hpp>

#include <Eigen/Core>
#include <cmath>

namespace tcert::statistics {

double standard_deviation(std::span<const double> values) {
  const Eigen::Map<const Eigen::VectorXd> x(values.data(),
                                            static_cast<Eigen::Index>(values.size()));
  if (x.size() < 2 || x.minCoeff() == x.maxCoeff()) {
    return 0.0;
  }
  return std::sqrt((x.array() - x.mean()).square().sum() / static_cast<double>(x.size() - 1));
}

}  // namespace tcert::statistics
