#include <table/atomic_file.hpp>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"

namespace tcert::table {
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

TEST(AtomicFile, RefusesWhatIsNoFileAtOnce) {
  const TemporaryFolder folder;
  const fs::path target = folder.write("target.csv", "mine");
  const fs::path link = folder.path() / "link";
  fs::create_symlink(target, link);
  fs::create_symlink(folder.path() / "nowhere", folder.path() / "dangling");
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const fs::path& path :
       {fs::path("/dev/null"), fs::path("/dev/full"), link, pipe, folder.path() / "dangling"}) {
    EXPECT_THROW(write_file_atomically(path, "x"), WriteError) << path;
    EXPECT_THROW(AtomicFolder{path}, WriteError) << path;
  }
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(read_text(target), "mine");
}

/// The number of a process that is dead.
pid_t dead_process() {
  const pid_t child = ::fork();
  if (child == 0) {
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return child;
}

TEST(Leftovers, OfDeadProcessesAreSweptAndNoOthers) {
  const TemporaryFolder folder;
  const std::string dead = std::to_string(dead_process());
  const std::string living = std::to_string(::getppid());
  folder.write(".out." + dead + "-0.tmp/a.csv", "half");
  folder.write(".out." + dead + "-12.tmp", "half");
  const std::vector<std::string> stay = {".out." + living + "-0.tmp",
                                         ".other." + dead + "-0.tmp",
                                         ".out." + dead + "-0.kept.tmp",
                                         ".out." + dead + ".tmp",
                                         ".out." + dead + "-x.tmp",
                                         ".out.-1-0.tmp",
                                         "out." + dead + "-0.tmp",
                                         ".out.tmp"};
  for (const std::string& name : stay) {
    folder.write(name, "mine");
  }
  fs::create_symlink(folder.path() / "out", folder.path() / (".out." + dead + "-1.tmp"));
  const AtomicFolder out(folder.path() / "out");
  EXPECT_EQ(entries(folder.path()), stay.size() + 2) << "those, the link, and our own";
  sweep_leftovers_in(folder.path());
  EXPECT_FALSE(fs::exists(folder.path() / (".other." + dead + "-0.tmp")));
  EXPECT_TRUE(fs::exists(out.staging()));
}

TEST(Leftovers, OfATemporaryAreCalledAfterWhatItIsCalledAfter) {
  const TemporaryFolder folder;
  AtomicFolder outer(folder.path() / "a");
  AtomicFolder inner(outer.staging());
  EXPECT_NE(inner.staging(), outer.staging());
  EXPECT_TRUE(inner.staging().filename().native().starts_with(".a.")) << inner.staging();
  inner.commit();
  outer.commit();
  EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(Leftovers, ThatAreHeldByALivingProcessStay) {
  const TemporaryFolder folder;
  const fs::path held = folder.write(".out." + std::to_string(dead_process()) + "-0.tmp", "half");
  const int descriptor = ::open(held.c_str(), O_RDONLY);
  ASSERT_EQ(::flock(descriptor, LOCK_SH), 0);
  sweep_leftovers(folder.path() / "out");
  EXPECT_TRUE(fs::exists(held)) << "another machine, or container, may count its processes anew";
  ::close(descriptor);
  sweep_leftovers(folder.path() / "out");
  EXPECT_FALSE(fs::exists(held));
}

TEST(AtomicFolder, GivesTheOldFolderBackIfItIsNotOursAnyMore) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "bundle";
  folder.write("bundle/old.csv", "edited");
  {
    AtomicFolder out(path, true);
    write_file_atomically(out.staging() / "new.csv", "new");
    EXPECT_THROW(out.commit([](const fs::path& old) {
      EXPECT_EQ(read_text(old / "old.csv"), "edited");
      throw WriteError("it was edited");
    }),
                 WriteError);
  }
  EXPECT_EQ(read_text(path / "old.csv"), "edited");
  EXPECT_EQ(entries(path), 1U);
  EXPECT_EQ(entries(folder.path()), 1U);
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
}  // namespace tcert::table
