#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>

namespace tcert {

/// The stupid inverse of packed().
inline std::string unpacked(const std::string& text) {
  static const std::string kAlphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text.substr(0, text.find('='))) {
    bits = bits << 6U | static_cast<unsigned>(kAlphabet.find(c));
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 255U);
    }
  }
  std::string out(1 << 16, '\0');
  uLongf size = out.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(out.data()),
                       &size,
                       reinterpret_cast<const Bytef*>(bytes.data()),
                       bytes.size()),
            Z_OK);
  return out.substr(0, size);
}

}  // namespace tcert
