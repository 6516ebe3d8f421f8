#pragma once

#include <bit>
#include <cstdint>

namespace gradmesh {

// Elementary functions without branches or calls, so that loops over them vectorise and give the
// same bits with every C library.

/// Cube root of a positive normal number, to a relative error of 3e-7.
inline float cube_root(float t) {
  // A float's bits are 2^23 (127 + log2) with the logarithm linear between powers of two; their
  // third is right to 7 %, and each of Halley's steps takes the error to its cube.
  constexpr float third = 1.0F / 3.0F;
  constexpr std::int32_t offset = 0x2a555555;  // 2/3 * 127 * 2^23
  const auto bits = std::int32_t(float(std::bit_cast<std::int32_t>(t)) * third) + offset;
  auto root = std::bit_cast<float>(bits);
  for (int step = 0; step < 2; ++step) {
    const float cube = root * root * root;
    root *= (cube + 2 * t) / (2 * cube + t);
  }
  return root;
}

/// Base-2 logarithm of a positive normal number; -127 for 0.
inline float log2_positive(float x) {
  // x = 2^exponent m with m from sqrt(1/2) to sqrt(2); log m = 2 atanh((m - 1) / (m + 1)).
  constexpr std::int32_t sqrt_half = 0x3f3504f3;
  const auto bits = std::bit_cast<std::int32_t>(x);
  const std::int32_t exponent = (bits - sqrt_half) >> 23;
  const auto m = std::bit_cast<float>(bits - exponent * (1 << 23));
  const float s = (m - 1) / (m + 1), s2 = s * s;
  constexpr float scale = 2.88539008F;  // 2 / ln 2
  return float(exponent) +
         scale * s * (1 + s2 * (1 / 3.0F + s2 * (1 / 5.0F + s2 * (1 / 7.0F + s2 * (1 / 9.0F)))));
}

/// 2^y for -127 <= y < 127.
inline float exp2_bounded(float y) {
  // Taylor's series on the part from -1/2 to 1/2, the rest in the exponent's bits.
  const auto whole = std::int32_t(y + 127.5F) - 127;
  const float t = (y - float(whole)) * 0.693147181F;
  const float series =
      1 +
      t * (1 + t * (1 / 2.0F +
                    t * (1 / 6.0F + t * (1 / 24.0F + t * (1 / 120.0F +
                                                          t * (1 / 720.0F + t * (1 / 5040.0F)))))));
  return series * std::bit_cast<float>((whole + 127) * (1 << 23));
}

/// x^p for x >= 0, 0 < p <= 1, to a relative error of 2e-6 for x from 1e-9 to 1e5 and of 6e-6 for
/// other normal numbers; exactly 0 for x = 0, exactly 1 for x = 1.
inline float power(float x, float p) {
  const float result = exp2_bounded(p * log2_positive(x));
  return x > 0 ? result : 0.0F;
}

}  // namespace gradmesh
