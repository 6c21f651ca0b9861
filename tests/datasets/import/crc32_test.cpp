#include "datasets/import/crc32.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <random>
#include <vector>

namespace tcert::recording {
namespace {

std::uint32_t by_zlib(std::span<const std::byte> bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

TEST(Crc32, IsThatOfZlibAtEveryLengthAndPlace) {
  std::mt19937 random(1);
  std::vector<std::byte> bytes(5000);
  for (std::byte& byte : bytes) {
    byte = static_cast<std::byte>(random());
  }
  for (std::size_t length = 0; length < 600; ++length) {
    for (const std::size_t start : {0U, 1U, 7U, 16U}) {
      const auto part = std::span(bytes).subspan(start, length);
      const auto before = static_cast<std::uint32_t>(random());
      ASSERT_EQ(crc32(part, before), by_zlib(part, before)) << length << " from " << start;
    }
  }
  EXPECT_EQ(crc32(bytes), by_zlib(bytes, 0));
  EXPECT_EQ(crc32({}), 0U);
}

TEST(Crc32, OfTwoPartsIsThatOfTheWhole) {
  const std::vector<std::byte> bytes(1000, std::byte{0x5A});
  const std::span<const std::byte> all(bytes);
  for (const std::size_t cut : {0U, 1U, 500U, 999U, 1000U}) {
    EXPECT_EQ(crc32_of_both(crc32(all.first(cut)), crc32(all.subspan(cut)), 1000 - cut),
              crc32(all));
  }
}

}  // namespace
}  // namespace tcert::recording
