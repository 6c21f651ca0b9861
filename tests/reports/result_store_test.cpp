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

TEST(ResultStore, TakesAnEntryInThePlaceOfAnotherForMissing) {
  const test_support::TemporaryFolder folder;
  const ResultStore store(folder.path());
  const std::string key = sha256("key");
  const std::string other = sha256("another");
  store.put(key, "some bytes");
  store.put(other, "other bytes");
  const auto path = [&](const std::string& of) {
    return folder.path() / of.substr(0, 2) / of.substr(2);
  };
  std::filesystem::copy_file(
      path(other), path(key), std::filesystem::copy_options::overwrite_existing);
  EXPECT_FALSE(store.get(key));
  EXPECT_EQ(store.get(other), "other bytes");
}

}  // namespace
}  // namespace tcert
