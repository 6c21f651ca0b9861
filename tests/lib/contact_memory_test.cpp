#include <gtest/gtest.h>

#include <cmath>
#include <tcert/contact_memory.hpp>

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

}  // namespace
}  // namespace tcert
