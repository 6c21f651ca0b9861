#include "reports/result_store.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "reports/sha256.hpp"
#include "support/temporary_folder.hpp"

namespace tcert {
namespace {

TEST(ResultStore, GivesBackWhatWasPut) {
  const test_support::TemporaryFolder folder;
  const ResultStore store(folder.path() / "store");
  const std::string key = sha256("what it was made from");
  EXPECT_FALSE(store.get(key));
  const std::string bytes("a\0b\n\nc", 6);
  store.put(key, bytes);
  EXPECT_EQ(store.get(key), bytes);
  store.put(key, bytes);
  EXPECT_EQ(ResultStore(folder.path() / "store").get(key), bytes);
  EXPECT_FALSE(store.get(sha256("something else")));
}

TEST(ResultStore, TakesADamagedEntryForMissing) {
  const test_support::TemporaryFolder folder;
  const ResultStore store(folder.path());
  const std::string key = sha256("key");
  store.put(key, "some bytes");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
    if (entry.is_regular_file()) {
      std::filesystem::resize_file(entry.path(), entry.file_size() - 1);
    }
  }
  EXPECT_FALSE(store.get(key));
  store.put(key, "some bytes");
  EXPECT_EQ(store.get(key), "some bytes");
}

}  // namespace
}  // namespace tcert
