#include "analysis/study/h1/comparison.hpp"

namespace tcert::study {

std::optional<Comparison> comparison_of(const H1Panel& panel, std::size_t row) {
  switch (panel.rows[row].kind) {
    case H1RowKind::predictor:
      return std::nullopt;
    case H1RowKind::rival:
    case H1RowKind::together:
      return Comparison{0, row};
    case H1RowKind::added:
      return Comparison{row, row - 1};
  }
  return std::nullopt;
}

}  // namespace tcert::study
