#include <algorithm>
#include <cmath>
#include <witness/banded_system.hpp>

namespace tcert::witness {

std::vector<double> BandedSystem::solved(double damping) const {
  const std::size_t n = right_.size();
  std::vector<std::array<double, kBand>> lower = matrix_;
  std::vector<double> x = right_;
  for (std::size_t i = 0; i < n; ++i) {
    lower[i][0] += damping;
    const std::size_t reach = std::min(i, kBand - 1);
    for (std::size_t back = reach; back > 0; --back) {
      const std::size_t j = i - back;
      double sum = lower[i][back];
      for (std::size_t k = 1; back + k <= reach; ++k) {
        sum -= lower[i][back + k] * lower[j][k];
      }
      lower[i][back] = sum / lower[j][0];
    }
    double pivot = lower[i][0];
    for (std::size_t back = 1; back <= reach; ++back) {
      pivot -= lower[i][back] * lower[i][back];
      x[i] -= lower[i][back] * x[i - back];
    }
    lower[i][0] = std::sqrt(std::max(pivot, damping * 1e-3));
    x[i] /= lower[i][0];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t ahead = 1; ahead < kBand && i + ahead < n; ++ahead) {
      x[i] -= lower[i + ahead][ahead] * x[i + ahead];
    }
    x[i] /= lower[i][0];
  }
  return x;
}

}  // namespace tcert::witness
