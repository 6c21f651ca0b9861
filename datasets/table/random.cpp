#include <table/random.hpp>

#include <Random123/philox.h>

#include <cmath>
#include <numbers>
#include <tcert/elementary.hpp>

namespace tcert::table {

RandomStream::RandomStream(std::uint64_t seed, std::uint32_t purpose, std::uint64_t index) noexcept
    : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U)},
      counter_{0U,
               purpose,
               static_cast<std::uint32_t>(index),
               static_cast<std::uint32_t>(index >> 32U)} {}

void RandomStream::refill() noexcept {
  const r123::Philox4x32::ctr_type counter{{counter_[0], counter_[1], counter_[2], counter_[3]}};
  const r123::Philox4x32::ukey_type key{{key_[0], key_[1]}};
  const auto block = r123::Philox4x32{}(counter, key);
  block_ = {block[0], block[1], block[2], block[3]};
  ++counter_[0];
  used_ = 0;
}

std::uint32_t RandomStream::bits() noexcept {
  if (used_ == 4) {
    refill();
  }
  return block_[static_cast<std::size_t>(used_++)];
}

double RandomStream::uniform() noexcept {
  const std::uint64_t high = bits() >> 5U;  // 27 bits
  const std::uint64_t low = bits() >> 6U;   // 26 bits
  const auto whole = static_cast<double>((high << 26U) | low);
  return (whole + 0.5) * 0x1.0p-53;
}

double RandomStream::uniform(double low, double high) noexcept {
  return low + (high - low) * uniform();
}

// Box-Muller; the two values of a pair are independent, the second waits for the next call.
double RandomStream::normal() noexcept {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  const double radius = std::sqrt(-2.0 * elementary::log(uniform()));
  const auto [sine, cosine] = elementary::sine_cosine(2.0 * std::numbers::pi * uniform());
  spare_ = radius * sine;
  has_spare_ = true;
  return radius * cosine;
}

// Rejection of the incomplete last interval (Lemire 2019).
std::uint32_t RandomStream::below(std::uint32_t n) noexcept {
  std::uint64_t product = std::uint64_t{bits()} * n;
  if (static_cast<std::uint32_t>(product) < n) {
    const std::uint32_t threshold = (0U - n) % n;
    while (static_cast<std::uint32_t>(product) < threshold) {
      product = std::uint64_t{bits()} * n;
    }
  }
  return static_cast<std::uint32_t>(product >> 32U);
}

}  // namespace tcert::table
