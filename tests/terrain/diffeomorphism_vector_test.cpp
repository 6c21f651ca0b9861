#include <gtest/gtest.h>

#include <terrain/power_cell.hpp>
#include <terrain/triangle_map.hpp>

#include "terrain/vectors.hpp"

namespace tcert::terrain {
namespace {

Position point(const nlohmann::json& value) {
  return {value[0].get<double>(), value[1].get<double>()};
}

std::vector<Position> points(const nlohmann::json& values) {
  std::vector<Position> result;
  for (const nlohmann::json& value : values) {
    result.push_back(point(value));
  }
  return result;
}

void expect_map(const TriangleMap& map, const nlohmann::json& expected) {
  const Position x = point(expected.at("x"));
  const Mapped m = map.map(x);
  const auto near = [&](const char* name, double found) {
    EXPECT_NEAR(expected.at(name).get<double>(), found, 1e-9) << name << " at " << x.transpose();
  };
  near("beta", m.beta);
  near("gamma", m.gamma);
  near("sigma_beta", m.sigma_beta);
  near("sigma_gamma", m.sigma_gamma);
  near("sigma", m.sigma);
  near("nu", m.nu);
  EXPECT_NEAR(expected.at("h")[0].get<double>(), m.x.x(), 1e-9);
  EXPECT_NEAR(expected.at("h")[1].get<double>(), m.x.y(), 1e-9);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(expected.at("J")[k].get<double>(),
                m.jacobian(static_cast<Eigen::Index>(k / 2), static_cast<Eigen::Index>(k % 2)),
                1e-9);
  }
  // The Jacobian by central differences.
  constexpr double kStep = 1e-6;
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2d d = kStep * Eigen::Vector2d::Unit(axis);
    const Eigen::Vector2d slope = (map.map(x + d).x - map.map(x - d).x) / (2.0 * kStep);
    EXPECT_LT((slope - m.jacobian.col(axis)).norm(), 1e-8) << x.transpose();
  }
}

TEST(DiffeomorphismVector, InteriorAndBoundaryRoots) {
  TCERT_NEED_VECTOR("testvec_diffeo.json");
  const nlohmann::json all = test::read_vector("testvec_diffeo.json");
  const nlohmann::json& interior = all.at("interior_root");
  const TriangleMap disc(
      points(interior.at("vertices")), points(interior.at("collar")), MapParameters{});
  EXPECT_NEAR(interior.at("rho").get<double>(), disc.radius(), 1e-12);
  for (const nlohmann::json& expected : interior.at("points")) {
    expect_map(disc, expected);
  }
  const nlohmann::json& boundary = all.at("boundary_root");
  const TriangleMap border(points(boundary.at("vertices")),
                           points(boundary.at("collar")),
                           point(boundary.at("centre")),
                           MapParameters{});
  for (const nlohmann::json& expected : boundary.at("points")) {
    expect_map(border, expected);
  }
}

TEST(DiffeomorphismVector, PowerCell) {
  TCERT_NEED_VECTOR("testvec_diffeo.json");
  const nlohmann::json v = test::read_vector("testvec_diffeo.json").at("power_cell");
  std::vector<Disc> sites;
  for (const nlohmann::json& site : v.at("sites")) {
    sites.push_back({point(site[0]), site[1].get<double>()});
  }
  const double radius = v.at("radius").get<double>();
  const std::vector<Position> cell = power_cell(
      {point(v.at("robot")), radius}, sites, {{0.0, 0.0}, {40.0, 0.0}, {40.0, 30.0}, {0.0, 30.0}});
  const std::vector<Position> expected = points(v.at("cell"));
  ASSERT_EQ(expected.size(), cell.size());
  for (std::size_t k = 0; k < cell.size(); ++k) {
    EXPECT_LT((expected[k] - cell[k]).norm(), 1e-9);
  }
  const std::vector<Position> inner = eroded(cell, radius);
  for (const Position& corner : points(v.at("eroded"))) {
    double nearest = 1e9;
    for (const Position& p : inner) {
      nearest = std::min(nearest, (p - corner).norm());
    }
    EXPECT_LT(nearest, 1e-9);
  }
  EXPECT_LT((nearest_point(inner, point(v.at("goal"))) - point(v.at("projected"))).norm(), 1e-9);
}

}  // namespace
}  // namespace tcert::terrain
