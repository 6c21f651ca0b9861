#include "reports/fit/matrix_table.hpp"

#include <gtest/gtest.h>

namespace tcert {
namespace {

TEST(MatrixTable, KeepsItsLabelsApartFromAPredictorOfThatName) {
  const Eigen::MatrixXd values = Eigen::MatrixXd::Identity(2, 2);
  EXPECT_EQ(matrix_table("vcov", "V", {"a", "b"}, values).columns.front().name, "term");
  EXPECT_EQ(matrix_table("vcov", "V", {"a", "term"}, values).columns.front().name, ".term");
  EXPECT_EQ(matrix_table("vcov", "V", {".term", "term"}, values).columns.front().name, "..term");
}

}  // namespace
}  // namespace tcert
