#include "reports/sha256.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace tcert {
namespace {

// The vectors of FIPS 180-4's example files.
TEST(Sha256, GivesTheStandardsVectors) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DoesNotDependOnThePieces) {
  Sha256 digest;
  digest.update("a");
  digest.update("");
  digest.update("bc");
  EXPECT_EQ(digest.finish(), sha256("abc"));
  digest.update("abc");
  EXPECT_EQ(digest.finish(), sha256("abc"));
}

class DigestFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("tcert_digest_" +
               std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_ / "b");
    write("a.txt", "abc");
    write("b/c.txt", "");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  std::filesystem::path folder_;
};

TEST_F(DigestFolder, IsTheDigestOfItsSortedDigests) {
  const FileDigest digest = digest_folder(folder_);
  EXPECT_EQ(digest.files, 2U);
  EXPECT_EQ(digest.bytes, 3U);
  EXPECT_EQ(digest.sha256, sha256(sha256("abc") + "  a.txt\n" + sha256("") + "  b/c.txt\n"));
}

TEST_F(DigestFolder, SeesARenamedAndAChangedFile) {
  const std::string before = digest_folder(folder_).sha256;
  write("a.txt", "abd");
  EXPECT_NE(digest_folder(folder_).sha256, before);
  write("a.txt", "abc");
  EXPECT_EQ(digest_folder(folder_).sha256, before);
  std::filesystem::rename(folder_ / "a.txt", folder_ / "d.txt");
  EXPECT_NE(digest_folder(folder_).sha256, before);
}

TEST_F(DigestFolder, ThrowsForAFileThatIsNotThere) {
  EXPECT_THROW((void)digest_file(folder_ / "none"), std::system_error);
}

}  // namespace
}  // namespace tcert
