#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <tcert/contact_memory.hpp>
#include <vector>

namespace tcert {
namespace {

TEST(ContactMemory, RisesWithForceAndFallsOffWithDistance) {
  ContactMemory memory{CertificateParameters{}};
  memory.add({0.05, 0.05}, 2.5, 0.0);  // a cell centre; half the cap
  EXPECT_NEAR(memory.largest_within({0.05, 0.05}, 0.01, 0.0), 0.05, 1e-15);
  const double at_15_cm = 0.05 * std::exp(-0.5 * (0.1 * 0.1) / (0.15 * 0.15));
  EXPECT_NEAR(memory.largest_within({0.15, 0.05}, 0.01, 0.0), at_15_cm, 1e-15);
  EXPECT_EQ(memory.largest_within({0.65, 0.05}, 0.01, 0.0), 0.0);  // cut at 3 sigma
}

// Against every cell by itself, each weight and each fading computed anew.
TEST(ContactMemory, IsTheFormulaAtEveryCell) {
  std::mt19937 engine(1);
  const auto uniform = [&engine](double low, double high) {
    return low + (high - low) * static_cast<double>(engine()) / 4294967296.0;
  };
  for (const double sigma_m : {0.15, 0.04, 0.6}) {
    CertificateParameters parameters;
    parameters.memory_sigma_m = sigma_m;
    ContactMemory memory(parameters);
    constexpr int kCells = 60;
    std::vector<double> values(kCells * kCells, 0.0);
    const auto centre = [](int k) { return 0.1 * (k - kCells / 2) + 0.05; };
    double time_s = 0.0;
    for (int k = 0; k < 200; ++k) {
      const double elapsed_s = k % 3 == 0 ? 0.0 : uniform(0.0, 3.0);
      time_s += elapsed_s;
      const Point contact{uniform(-1.0, 1.0), uniform(-1.0, 1.0)};
      const double force_n = uniform(0.0, 7.0);
      memory.add(contact, force_n, time_s);
      for (int cell = 0; cell < kCells * kCells; ++cell) {
        double& value = values[static_cast<std::size_t>(cell)];
        const Point at{centre(cell % kCells), centre(cell / kCells)};
        const double d_m = distance(at, contact);
        value *= std::exp2(-elapsed_s / 20.0);
        if (d_m <= 3.0 * sigma_m) {
          value += (1.0 - value) * 0.1 * std::min(force_n, 5.0) / 5.0 *
                   std::exp(-d_m * d_m / (2.0 * sigma_m * sigma_m));
        }
        if (k % 20 == 19) {
          ASSERT_NEAR(memory.largest_within(at, 0.01, time_s), value, 1e-12);
        }
      }
    }
  }
}

TEST(ContactMemory, SaturatesAtOne) {
  ContactMemory memory{CertificateParameters{}};
  memory.add({0.05, 0.05}, 50.0, 0.0);  // capped
  memory.add({0.05, 0.05}, 50.0, 0.0);
  EXPECT_NEAR(memory.largest_within({0.05, 0.05}, 0.01, 0.0), 0.1 + 0.9 * 0.1, 1e-15);
  for (int k = 0; k < 1000; ++k) {
    memory.add({0.05, 0.05}, 5.0, 0.0);
  }
  EXPECT_LE(memory.largest_within({0.05, 0.05}, 0.01, 0.0), 1.0);
}

TEST(ContactMemory, HalvesEveryHalfLifeHoweverItIsRead) {
  ContactMemory memory{CertificateParameters{}};
  memory.add({0.05, 0.05}, 5.0, 0.0);
  EXPECT_NEAR(memory.largest_within({0.05, 0.05}, 0.01, 20.0), 0.05, 1e-15);
  EXPECT_NEAR(memory.largest_within({0.05, 0.05}, 0.01, 40.0), 0.025, 1e-15);
  memory.add({0.05, 0.05}, 5.0, 40.0);
  EXPECT_NEAR(memory.largest_within({0.05, 0.05}, 0.01, 40.0), 0.025 + 0.975 * 0.1, 1e-15);
}

TEST(ContactMemory, TakesAMissingForceForTheCap) {
  ContactMemory memory{CertificateParameters{}};
  memory.add({0.05, 0.05}, std::nan(""), 0.0);
  EXPECT_NEAR(memory.largest_within({0.05, 0.05}, 0.01, 0.0), 0.1, 1e-15);
}

TEST(ContactMemory, LosesTheFaintestCellsWhenItIsFull) {
  CertificateParameters parameters;
  parameters.max_memory_cells = 256;
  ContactMemory memory(parameters);
  for (int k = 0; k < 100; ++k) {
    memory.add({0.05 + k, 0.05}, 5.0, static_cast<double>(k));
  }
  EXPECT_GT(memory.largest_within({99.05, 0.05}, 0.2, 99.0), 0.05);
}

TEST(ContactMemory, SaysWhenWhatItLosesStillCounted) {
  CertificateParameters parameters;
  parameters.max_memory_cells = 256;
  for (const double apart_s : {1.0, 10'000.0}) {
    ContactMemory memory(parameters);
    for (int k = 0; k < 100; ++k) {
      memory.add({0.05 + k, 0.05}, 5.0, apart_s * k);
    }
    EXPECT_EQ(memory.evicted(), apart_s == 1.0) << "faded memory is no loss";
    memory.clear();
    EXPECT_FALSE(memory.evicted());
  }
}

TEST(ContactMemory, ForgetsATrial) {
  ContactMemory memory{CertificateParameters{}};
  memory.add({0.05, 0.05}, 5.0, 0.0);
  memory.clear();
  EXPECT_EQ(memory.largest_within({0.05, 0.05}, 1.0, 0.0), 0.0);
}

// A memory of contacts all about the origin, and draws in [low, high).
class Scattered {
 public:
  explicit Scattered(std::uint32_t seed) : engine_(seed) {
    for (int k = 0; k < 40; ++k) {
      time_s_ += uniform(0.0, 3.0);
      const Point contact{uniform(-1.0, 1.0), uniform(-1.0, 1.0)};
      const double force_n = uniform(0.0, 7.0);
      memory_.add(contact, force_n, time_s_);
      mirrored_.add({contact.x_m, -contact.y_m}, force_n, time_s_);
    }
  }

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }
  [[nodiscard]] const ContactMemory& memory() const { return memory_; }
  [[nodiscard]] const ContactMemory& mirrored() const { return mirrored_; }
  [[nodiscard]] double time_s() const { return time_s_; }

 private:
  std::mt19937 engine_;
  ContactMemory memory_{CertificateParameters{}};
  ContactMemory mirrored_{CertificateParameters{}};
  double time_s_ = 0.0;
};

// Against the mean over many points, at each the value of its cell.
TEST(ContactMemory, TheMeanAlongALineIsThatOfItsPoints) {
  Scattered scattered(2);
  for (int line = 0; line < 60; ++line) {
    const Point from{scattered.uniform(-1.5, 1.5), scattered.uniform(-1.5, 1.5)};
    const double angle_rad = scattered.uniform(-3.2, 3.2);
    const Point u{std::cos(angle_rad), std::sin(angle_rad)};
    const double length_m = scattered.uniform(0.01, 2.0);
    const double time_s = scattered.time_s() + scattered.uniform(0.0, 30.0);
    constexpr int kPoints = 20'000;
    double sum = 0.0;
    for (int i = 0; i < kPoints; ++i) {
      const Point at = from + ((i + 0.5) * length_m / kPoints) * u;
      const Point centre{0.1 * std::floor(at.x_m / 0.1) + 0.05,
                         0.1 * std::floor(at.y_m / 0.1) + 0.05};
      sum += scattered.memory().largest_within(centre, 0.01, time_s);
    }
    // At each of some 30 borders one point may count for the wrong cell.
    EXPECT_NEAR(
        scattered.memory().mean_along(from, u, length_m, time_s), sum / kPoints, 30.0 / kPoints)
        << "line " << line;
  }
}

// By hand: 0.05 m in the cell of the contact, 0.1 m in the next and 0.05 m in the third.
TEST(ContactMemory, TheMeanAlongALineWeighsCellsByTheirLength) {
  ContactMemory memory{CertificateParameters{}};
  memory.add({0.05, 0.05}, 5.0, 0.0);
  const auto at = [&](double x_m) { return memory.largest_within({x_m, 0.05}, 0.01, 0.0); };
  const double mean = (0.05 * at(0.05) + 0.1 * at(0.15) + 0.05 * at(0.25)) / 0.2;
  EXPECT_NEAR(memory.mean_along({0.05, 0.05}, {1.0, 0.0}, 0.2, 0.0), mean, 1e-15);
  EXPECT_NEAR(memory.mean_along({0.25, 0.05}, {-1.0, 0.0}, 0.2, 0.0), mean, 1e-15);
  EXPECT_NEAR(memory.mean_along({0.05, 0.05}, {1.0, 0.0}, 0.2, 20.0), 0.5 * mean, 1e-15);
  EXPECT_NEAR(memory.mean_along({0.02, 0.02}, {0.6, 0.8}, 0.01, 0.0), at(0.05), 1e-15);
  EXPECT_EQ(memory.mean_along({5.0, 5.0}, {1.0, 0.0}, 0.2, 0.0), 0.0);
  EXPECT_EQ(memory.mean_along({1e9, 0.0}, {1.0, 0.0}, 0.2, 0.0), 0.0);
}

TEST(ContactMemory, AlongABorderTheMeanIsThatOfBothRows) {
  ContactMemory memory{CertificateParameters{}};
  memory.add({0.07, 0.06}, 5.0, 0.0);
  const double above = memory.mean_along({0.0, 0.05}, {1.0, 0.0}, 0.4, 0.0);
  const double below = memory.mean_along({0.0, -0.05}, {1.0, 0.0}, 0.4, 0.0);
  ASSERT_NE(above, below);
  EXPECT_NEAR(memory.mean_along({0.0, 0.0}, {1.0, 0.0}, 0.4, 0.0), 0.5 * (above + below), 1e-15);
  EXPECT_NEAR(memory.mean_along({0.0, 0.0}, {0.0, -1.0}, 0.05, 0.0),
              0.5 * (memory.mean_along({0.05, 0.0}, {0.0, -1.0}, 0.05, 0.0) +
                     memory.mean_along({-0.05, 0.0}, {0.0, -1.0}, 0.05, 0.0)),
              1e-15);
}

TEST(ContactMemory, TheMirroredLineThroughTheMirroredMemoryHasTheSameBits) {
  Scattered scattered(3);
  const ContactMemory& memory = scattered.memory();
  const ContactMemory& mirrored = scattered.mirrored();
  for (int line = 0; line < 20'000; ++line) {
    // Some begin on borders, some run along them.
    const double y_m = line % 4 == 0 ? 0.1 * (line % 9 - 4) : scattered.uniform(-1.5, 1.5);
    const Point from{scattered.uniform(-1.5, 1.5), y_m};
    const double angle_rad = scattered.uniform(-3.2, 3.2);
    const Point u =
        line % 8 == 0 ? Point{1.0, 0.0} : Point{std::cos(angle_rad), std::sin(angle_rad)};
    ASSERT_EQ(memory.mean_along(from, u, 0.6, scattered.time_s()),
              mirrored.mean_along({from.x_m, -y_m}, {u.x_m, -u.y_m}, 0.6, scattered.time_s()))
        << "line " << line;
  }
}

}  // namespace
}  // namespace tcert
