#pragma once
/// \file
/// A text that has to hold another one.

#include <gtest/gtest.h>

#include <string>

namespace tcert::test_support {

inline void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(std::string::npos, text.find(part)) << text << "\nlacks: " << part;
}

}  // namespace tcert::test_support
