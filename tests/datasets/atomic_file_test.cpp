#include "datasets/atomic_file.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <iterator>

#include "support/temporary_folder.hpp"

namespace tcert {
namespace {

namespace fs = std::filesystem;
using test_support::read_text;
using test_support::TemporaryFolder;

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

TEST(AtomicFile, AppearsOnlyWhenCommitted) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "deep" / "er" / "a.csv";
  AtomicFile file(path);
  file.write("one\n");
  file.write("two\n");
  EXPECT_FALSE(fs::exists(path));
  file.commit();
  EXPECT_EQ(read_text(path), "one\ntwo\n");
  EXPECT_EQ(entries(path.parent_path()), 1U);
}

TEST(AtomicFile, LeavesNothingWhenNotCommitted) {
  const TemporaryFolder folder;
  { AtomicFile(folder.path() / "a.csv").write("half"); }
  EXPECT_EQ(entries(folder.path()), 0U);
}

TEST(AtomicFile, KeepsTheOldFileUntilTheNewIsWhole) {
  const TemporaryFolder folder;
  const fs::path path = folder.write("a.csv", "old");
  { AtomicFile(path).write("new"); }
  EXPECT_EQ(read_text(path), "old");
  write_file_atomically(path, "new");
  EXPECT_EQ(read_text(path), "new");
}

TEST(AtomicFile, KilledRunLeavesNoFileUnderTheFinalName) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.csv";
  const pid_t child = ::fork();
  if (child == 0) {
    AtomicFile file(path);
    file.write("half a fi");
    ::raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_FALSE(fs::exists(path));
  write_file_atomically(path, "whole");
  EXPECT_EQ(read_text(path), "whole");
}

TEST(AtomicFile, NamesThePathAndTheReasonWhenItCannotWrite) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a.csv", "");
  try {
    write_file_atomically(file / "b.csv", "x");
    FAIL() << "wrote below a file";
  } catch (const WriteError& error) {
    EXPECT_NE(std::string(error.what()).find("a.csv"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("Not a directory"), std::string::npos);
  }
  EXPECT_THROW(write_file_atomically(folder.path(), "x"), WriteError);
}

TEST(AtomicFile, WritesIntoADeviceWithoutReplacingIt) {
  write_file_atomically("/dev/null", "x");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_THROW(write_file_atomically("/dev/full", "x"), WriteError);
}

TEST(AtomicFolder, AppearsWholeOrNotAtAll) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "bundle";
  {
    const AtomicFolder out(path);
    write_file_atomically(out.staging() / "a.csv", "x");
  }
  EXPECT_EQ(entries(folder.path()), 0U);
  AtomicFolder out(path);
  write_file_atomically(out.staging() / "a.csv", "x");
  EXPECT_FALSE(fs::exists(path));
  out.commit();
  EXPECT_EQ(read_text(path / "a.csv"), "x");
  EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(AtomicFolder, ReplacesAFullFolderOnlyWhenAsked) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "bundle";
  folder.write("bundle/old.csv", "old");
  EXPECT_THROW(AtomicFolder{path}, WriteError);
  AtomicFolder out(path, true);
  write_file_atomically(out.staging() / "new.csv", "new");
  out.commit();
  EXPECT_FALSE(fs::exists(path / "old.csv"));
  EXPECT_EQ(read_text(path / "new.csv"), "new");
  EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(AtomicFolder, TakesTheNameOfAnEmptyFolder) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "bundle";
  fs::create_directory(path);
  AtomicFolder out(path);
  out.commit();
  EXPECT_TRUE(fs::is_directory(path));
  EXPECT_EQ(entries(folder.path()), 1U);
}

}  // namespace
}  // namespace tcert
