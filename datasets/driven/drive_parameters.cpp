#include "datasets/driven/drive_parameters.hpp"

#include <stdexcept>

namespace tcert {
namespace {

constexpr double kMostSteps = 2e6;

}  // namespace

void validate(const DriveParameters& parameters) {
  require_fields(parameters);
  if (parameters.time_limit_s / parameters.step_s > kMostSteps) {
    throw std::invalid_argument("drive_time_limit_s / drive_step_s is " +
                                to_text(parameters.time_limit_s / parameters.step_s) +
                                "; it must be at most " + to_text(kMostSteps));
  }
}

}  // namespace tcert
