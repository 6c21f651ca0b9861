#include <statistics/glmm/glmm.hpp>

namespace tcert::statistics {

GlmmInput glmm_input(const ModelFrame& frame) {
  return {logistic_input(frame), frame.random_effects};
}

}  // namespace tcert::statistics
