#include "datasets/import/crc32.hpp"

#include <zlib.h>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace tcert::recording {
namespace {

std::uint32_t by_zlib(std::span<const std::byte> bytes, std::uint32_t before) noexcept {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

#if defined(__x86_64__)

constexpr std::size_t kBlock = 64;  // bytes that are folded at once
constexpr std::size_t kLane = 16;

/// `lane` moved on by the distance that `factors` stand for, onto `next`.
__attribute__((target("pclmul,sse4.1"))) inline __m128i folded(__m128i lane,
                                                               __m128i factors,
                                                               __m128i next) noexcept {
  const __m128i low = _mm_clmulepi64_si128(lane, factors, 0x00);
  const __m128i high = _mm_clmulepi64_si128(lane, factors, 0x11);
  return _mm_xor_si128(_mm_xor_si128(low, high), next);
}

__attribute__((target("pclmul,sse4.1"))) inline __m128i load(const std::byte* at) noexcept {
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(at));
}

/// The CRC register (not inverted) after `bytes`, a multiple of 16 and at least 64, by folding: V.
/// Gopal et al., "Fast CRC Computation for Generic Polynomials Using PCLMULQDQ Instruction", Intel
/// 2009. The factors are x^k modulo the polynomial, bits reflected, of k = 4·128 ± 32, 128 ±
/// 32, 64.
__attribute__((target("pclmul,sse4.1"))) std::uint32_t by_folding(std::span<const std::byte> bytes,
                                                                  std::uint32_t state) noexcept {
  const __m128i by_four = _mm_set_epi64x(0x1c6e41596, 0x154442bd4);
  const __m128i by_one = _mm_set_epi64x(0x0ccaa009e, 0x1751997d0);
  const __m128i by_half = _mm_set_epi64x(0, 0x163cd6124);
  const __m128i polynomial = _mm_set_epi64x(0x1f7011641, 0x1db710641);  // and its inverse
  const __m128i low_word = _mm_setr_epi32(-1, 0, -1, 0);

  const std::byte* at = bytes.data();
  const std::byte* end = at + bytes.size();
  __m128i a = _mm_xor_si128(load(at), _mm_cvtsi32_si128(static_cast<int>(state)));
  __m128i b = load(at + kLane);
  __m128i c = load(at + 2 * kLane);
  __m128i d = load(at + 3 * kLane);
  for (at += kBlock; at + kBlock <= end; at += kBlock) {
    a = folded(a, by_four, load(at));
    b = folded(b, by_four, load(at + kLane));
    c = folded(c, by_four, load(at + 2 * kLane));
    d = folded(d, by_four, load(at + 3 * kLane));
  }
  a = folded(folded(folded(a, by_one, b), by_one, c), by_one, d);
  for (; at + kLane <= end; at += kLane) {
    a = folded(a, by_one, load(at));
  }
  // 128 bits to 64, and those to 32 by Barrett's reduction.
  a = _mm_xor_si128(_mm_srli_si128(a, 8), _mm_clmulepi64_si128(a, by_one, 0x10));
  a = _mm_xor_si128(_mm_srli_si128(a, 4),
                    _mm_clmulepi64_si128(_mm_and_si128(a, low_word), by_half, 0x00));
  __m128i quotient = _mm_clmulepi64_si128(_mm_and_si128(a, low_word), polynomial, 0x10);
  quotient = _mm_clmulepi64_si128(_mm_and_si128(quotient, low_word), polynomial, 0x00);
  return static_cast<std::uint32_t>(_mm_extract_epi32(_mm_xor_si128(a, quotient), 1));
}

bool can_fold() noexcept {
  static const bool can = static_cast<bool>(__builtin_cpu_supports("pclmul")) &&
                          static_cast<bool>(__builtin_cpu_supports("sse4.1"));
  return can;
}

#endif

}  // namespace

std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t before) noexcept {
#if defined(__x86_64__)
  if (bytes.size() >= kBlock && can_fold()) {
    const std::size_t whole = bytes.size() / kLane * kLane;
    return by_zlib(bytes.subspan(whole), ~by_folding(bytes.first(whole), ~before));
  }
#endif
  return by_zlib(bytes, before);
}

std::uint32_t crc32_of_both(std::uint32_t first,
                            std::uint32_t second,
                            std::size_t length) noexcept {
  return static_cast<std::uint32_t>(crc32_combine64(first, second, static_cast<z_off64_t>(length)));
}

}  // namespace tcert::recording
