#include "cli/runs/batch/part.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <memory>
#include <optional>
#include <system_error>
#include <table/regular_file.hpp>
#include <utility>

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnd = "# end ";
constexpr std::size_t kBlock = std::size_t{1} << 20U;
constexpr std::size_t kLongestLine = std::size_t{1} << 30U;

std::string head_of(const ReadPlan& plan, std::uint64_t shard) {
  const ItemRange range = plan.plan.range_of(shard);
  return fmt::format(
      "# tcert part, version 1\n# plan {}\n# program {}\n# arithmetic {}\n# shard {} of {}\n"
      "# items {} up to, but not with, {} of {}\n",
      plan.digest,
      plan.plan.program,
      plan.plan.arithmetic,
      shard,
      plan.plan.shards,
      range.first,
      range.last,
      plan.plan.count());
}

[[noreturn]] void refuse(const fs::path& path, const std::string& what) {
  throw BadData("the part '" + path.string() + "' " + what +
                "; remove it, and its shard can be made again");
}

/// What a line of the head is about: "plan" of "# plan 1a2b...".
std::string_view key_of(std::string_view line) {
  line.remove_prefix(2);
  return line.substr(0, line.find(' '));
}

/// A regular file, line by line.
class Lines {
 public:
  /// \throws NoInput if it cannot be read.
  explicit Lines(const fs::path& path) : path_(path) {
    std::string problem;
    const int descriptor = table::open_regular_file(path, problem);
    if (descriptor < 0) {
      throw NoInput("cannot read the part '" + path.string() + "': " + problem);
    }
    file_.reset(::fdopen(descriptor, "rb"));
    if (!file_) {
      ::close(descriptor);
      throw NoInput("cannot read the part '" + path.string() +
                    "': " + std::generic_category().message(errno));
    }
  }

  /// The next line without its line feed; none at the end. \throws NoInput; BadData for a line that
  /// is too long, or that has no line feed.
  std::optional<std::string_view> next() {
    line_.clear();
    // Nobody else reads this file, so that no lock is needed for each character.
    for (int c = ::getc_unlocked(file_.get()); c != EOF; c = ::getc_unlocked(file_.get())) {
      if (c == '\n') {
        return line_;
      }
      if (line_.size() == kLongestLine) {
        refuse(path_, "has a line that is too long");
      }
      line_ += static_cast<char>(c);
    }
    if (std::ferror(file_.get()) != 0) {
      throw NoInput("cannot read the part '" + path_.string() +
                    "': " + std::generic_category().message(errno));
    }
    if (!line_.empty()) {
      refuse(path_, "is not whole: it ends within a line");
    }
    return std::nullopt;
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
  };

  fs::path path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::string line_;
};

void require_head(const fs::path& path, std::string_view expected, Lines& lines, Sha256& sum) {
  while (!expected.empty()) {
    const std::string_view line = expected.substr(0, expected.find('\n'));
    const std::string_view found = lines.next().value_or("");
    if (found != line) {
      const std::string_view key = key_of(line);
      refuse(path,
             key == "tcert" || !found.starts_with("# " + std::string(key))
                 ? "is none of this tool"
                 : fmt::format("is of another {}: found '{}', expected '{}'", key, found, line));
    }
    sum.update(line);
    sum.update("\n");
    expected.remove_prefix(line.size() + 1);
  }
}

/// Reads a part from its head to its end. \throws BadData.
void scan(const ReadPlan& plan,
          std::uint64_t shard,
          const std::function<void(std::uint64_t item, std::string_view line)>& take) {
  const fs::path path = part_path(plan, shard);
  Lines lines(path);
  Sha256 sum;
  require_head(path, head_of(plan, shard), lines, sum);
  const ItemRange range = plan.plan.range_of(shard);
  for (std::uint64_t item = range.first; item < range.last; ++item) {
    const auto line = lines.next();
    if (!line) {
      refuse(path, "ends too early: it is not whole");
    }
    std::uint64_t number = 0;
    const char* const end = line->data() + line->size();
    const auto [stop, error] = std::from_chars(line->data(), end, number);
    if (error != std::errc{} || number != item || stop == end || *stop != ',') {
      refuse(path, fmt::format("is damaged: expected item {}", item));
    }
    sum.update(*line);
    sum.update("\n");
    take(item, {stop + 1, end});
  }
  const bool has_end = lines.next() == std::string(kEnd) + sum.finish();
  if (!has_end || lines.next()) {
    refuse(path, "is damaged: its end does not fit what is before");
  }
}

/// The last line of a file that is whole.
std::string end_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  constexpr std::streamoff kLength = 6 + 64 + 1;
  file.seekg(-kLength, std::ios::end);
  std::string line;
  std::getline(file, line);
  return line;
}

}  // namespace

fs::path part_path(const ReadPlan& plan, std::uint64_t shard) {
  return plan.folder / "parts" / fmt::format("{:06}.csv", shard);
}

PartWriter::PartWriter(const ReadPlan& plan, std::uint64_t shard)
    : path_(part_path(plan, shard)), file_(path_) {
  write(head_of(plan, shard));
}

void PartWriter::write(std::string_view text) {
  sum_.update(text);
  pending_ += text;
  if (pending_.size() >= kBlock) {
    file_.write(std::exchange(pending_, {}));
  }
}

void PartWriter::add(std::uint64_t item, std::string_view line) {
  write(fmt::format("{},{}\n", item, line));
}

bool PartWriter::commit() {
  const std::string end = std::string(kEnd) + sum_.finish();
  file_.write(pending_ + end + '\n');
  if (file_.commit_new()) {
    return true;
  }
  if (end_of(path_) != end) {
    throw BadData("the part '" + path_.string() +
                  "' was made by another process meanwhile and differs from what this one made, "
                  "which is dropped: the same shard must give the same bytes");
  }
  return false;
}

bool has_part(const ReadPlan& plan, std::uint64_t shard) {
  std::error_code error;
  const fs::path path = part_path(plan, shard);
  const fs::file_status status = fs::symlink_status(path, error);
  if (status.type() == fs::file_type::not_found) {
    return false;
  }
  if (error) {
    throw NoInput("cannot look at the part '" + path.string() + "': " + error.message());
  }
  scan(plan, shard, [](std::uint64_t /*item*/, std::string_view /*line*/) {});
  return true;
}

void read_part(const ReadPlan& plan,
               std::uint64_t shard,
               const std::function<void(std::uint64_t item, std::string_view line)>& take) {
  scan(plan, shard, take);
}

}  // namespace tcert::cli
