#pragma once
/// \file
/// Published test vectors and terrain, for tests; they skip where the files are not there.

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <table/bytes.hpp>
#include <table/csv.hpp>
#include <terrain/grid.hpp>
#include <vector>

#include "support/temporary_folder.hpp"

namespace tcert::terrain::test {

/// The folder of the vectors.
[[nodiscard]] inline std::filesystem::path vectors() {
  return test_support::shared_data() / "srpgt";
}

/// A JSON file whose infinities are written as Python writes them: they become strings.
[[nodiscard]] inline nlohmann::json read_vector(const std::string& name) {
  std::string text = test_support::read_text(vectors() / name);
  for (const std::string word : {"-Infinity", "Infinity"}) {
    for (std::size_t at = text.find(word); at != std::string::npos;
         at = text.find(word, at + word.size() + 2)) {
      const bool quoted = at > 0 && (text[at - 1] == '"' || text[at - 1] == '-');
      if (!quoted) {
        text.replace(at, word.size(), '"' + word + '"');
      }
    }
  }
  return nlohmann::json::parse(text);
}

[[nodiscard]] inline double number(const nlohmann::json& value) {
  if (value.is_string()) {
    return value.get<std::string>() == "Infinity" ? INFINITY : -INFINITY;
  }
  return value.get<double>();
}

/// f of the small vectors, on 20 x 15 cells.
[[nodiscard]] inline double small_field(Cell c) {
  const double i = c.x;
  const double j = c.y;
  return 1.0 + 0.9 * std::sin(0.35 * i + 0.4) * std::cos(0.28 * j - 0.5) -
         1.1 * std::exp(-((i - 11) * (i - 11) + (j - 7) * (j - 7)) / 12.0);
}

}  // namespace tcert::terrain::test

#define TCERT_NEED_VECTOR(name)                                              \
  if (!std::filesystem::exists(tcert::terrain::test::vectors() / (name))) {  \
    GTEST_SKIP() << "missing: " << tcert::terrain::test::vectors() / (name); \
  }
