#include <statistics/glmm/glmm.hpp>

namespace tcert {

GlmmInput glmm_input(const ModelFrame& frame) {
  return {logistic_input(frame), frame.random_effects};
}

}  // namespace tcert
