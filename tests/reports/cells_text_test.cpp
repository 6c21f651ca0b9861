#include "reports/experiment/cells_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tcert {
namespace {

TEST(CellRows, ReadBackToTheSameCells) {
  CellRows rows;
  rows = {{std::string("paper"),
           std::int64_t{660},
           TableCell{},
           Number{1.0 / 3.0},
           Number{std::nan(""), 2},
           Estimate{0.1, -0.3, std::nan("")},
           PValue{1e-300}},
          {std::int64_t{3}, Number{0.7}}};
  const CellRows again = cell_rows_from(to_text(rows));
  EXPECT_EQ(to_text(again), to_text(rows));
  EXPECT_EQ(std::get<Number>(again[0][3]).value, 1.0 / 3.0);
  EXPECT_EQ(std::get<Number>(again[0][4]).decimals, 2);
  EXPECT_EQ(std::get<Estimate>(again[0][5]).low, -0.3);
  EXPECT_TRUE(std::isnan(std::get<Estimate>(again[0][5]).high));
  EXPECT_EQ(std::get<PValue>(again[0][6]).value, 1e-300);
  EXPECT_THROW(static_cast<void>(cell_rows_from("[")), std::invalid_argument);
}

}  // namespace
}  // namespace tcert
