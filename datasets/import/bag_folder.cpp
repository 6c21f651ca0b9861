#include "datasets/import/bag_folder.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <table/bytes.hpp>
#include <table/path_name.hpp>
#include <utility>

#include "datasets/import/bag_metadata.hpp"

namespace tcert::recording {
namespace {

namespace fs = std::filesystem;

using table::Severity;

constexpr const char* kMetadata = "metadata.yaml";

bool is_recording_name(const fs::path& path) {
  return path.extension() == ".db3" || path.extension() == ".mcap";
}

bool is_packed_name(const fs::path& path) {
  return (path.extension() == ".zstd" || path.extension() == ".zst") &&
         is_recording_name(path.stem());
}

/// The file that metadata.yaml means by `name`: older recorders put the folder's own name before
/// it.
fs::path listed_file(const fs::path& folder, const std::string& name) {
  std::error_code error;
  fs::path direct = folder / name;
  if (table::leads_below(name) && fs::exists(direct, error)) {
    return direct;
  }
  const fs::path beside = folder / fs::path(name).filename();
  const fs::path expanded = folder / fs::path(name).stem();
  return is_packed_name(beside) && fs::exists(expanded, error) ? expanded : beside;
}

/// "run" of "run_3.db3" and "run_3.mcap.zstd": what the files of one recording have in common.
std::string recording_of(const fs::path& file) {
  const fs::path bare = is_packed_name(file) ? file.stem().stem() : file.stem();
  std::string name = bare.string();
  const std::size_t last = name.find_last_not_of("0123456789");
  if (last != std::string::npos && name[last] == '_') {
    name.resize(last);
  }
  return name;
}

/// rosbag2 calls the files of one recording by its folder and counts from 0.
bool is_one_recording(const std::vector<fs::path>& files, const fs::path& folder) {
  if (files.size() == 1) {
    return true;
  }
  const std::string name = recording_of(files.front());
  const bool has_one_name = std::ranges::all_of(
      files, [&name](const fs::path& file) { return recording_of(file) == name; });
  const fs::path first = is_packed_name(files.front()) ? files.front().stem() : files.front();
  return has_one_name && (name == fs::weakly_canonical(folder).filename().string() ||
                          first.stem().string() == name + "_0");
}

/// In the order of their numbers; none if they are of several recordings.
std::vector<fs::path> files_by_name(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (is_recording_name(it->path()) || is_packed_name(it->path())) {
      files.push_back(it->path());
    }
  }
  std::ranges::sort(files, [](const fs::path& a, const fs::path& b) {
    return counts_before(a.filename().string(), b.filename().string());
  });
  // What somebody has expanded beside the packed file is one recording, not two.
  std::erase_if(files, [&files](const fs::path& file) {
    return is_packed_name(file) &&
           std::ranges::count(files, fs::path(file).replace_extension()) > 0;
  });
  return !files.empty() && is_one_recording(files, folder) ? files : std::vector<fs::path>{};
}

std::vector<fs::path> files_of(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  const fs::path metadata = folder / kMetadata;
  if (fs::exists(metadata, error)) {
    const table::BytesResult text = table::read_file(metadata);
    for (const std::string& name :
         text.bytes ? relative_file_paths(text.bytes->view()) : std::vector<std::string>{}) {
      files.push_back(listed_file(folder, name));
    }
  }
  return files.empty() ? files_by_name(folder) : files;
}

/// Several files, one behind the other.
class FolderBag final : public Bag {
 public:
  void add(std::unique_ptr<Bag> file);

  [[nodiscard]] bool empty() const noexcept { return files_.empty(); }
  [[nodiscard]] const std::vector<Topic>& topics() const override { return topics_; }

  void for_each(std::span<const std::size_t> wanted,
                const MessageVisitor& visit,
                table::DiagnosticGroups& problems) override;

 private:
  struct File {
    std::unique_ptr<Bag> bag;
    std::vector<std::size_t> topic;  // index into topics_, by that of the file
  };
  std::vector<File> files_;
  std::vector<Topic> topics_;
  std::map<std::array<std::string, 3>, std::size_t> index_;
};

void FolderBag::add(std::unique_ptr<Bag> file) {
  File added{std::move(file), {}};
  for (const Topic& topic : added.bag->topics()) {
    const auto [place, is_new] =
        index_.try_emplace({topic.name, topic.type, topic.encoding}, topics_.size());
    if (is_new) {
      topics_.push_back(topic);
    } else {
      Topic& known = topics_[place->second];
      known.messages += topic.messages;
      if (known.definition.empty()) {
        known.definition = topic.definition;
        known.definition_encoding = topic.definition_encoding;
      }
    }
    added.topic.push_back(place->second);
  }
  files_.push_back(std::move(added));
}

void FolderBag::for_each(std::span<const std::size_t> wanted,
                         const MessageVisitor& visit,
                         table::DiagnosticGroups& problems) {
  bool goes_on = true;
  for (const File& file : files_) {
    std::vector<std::size_t> wanted_here;
    for (std::size_t i = 0; i < file.topic.size(); ++i) {
      if (std::ranges::count(wanted, file.topic[i]) > 0) {
        wanted_here.push_back(i);
      }
    }
    file.bag->for_each(
        wanted_here,
        [&](const RawMessage& message) {
          RawMessage shown = message;
          shown.topic = file.topic[message.topic];
          goes_on = visit(shown);
          return goes_on;
        },
        problems);
    if (!goes_on) {
      return;
    }
  }
}

std::unique_ptr<Bag> open_file(const fs::path& path, table::DiagnosticGroups& problems) {
  std::error_code error;
  if (is_packed_name(path) && fs::exists(path, error)) {
    problems.add({Severity::error,
                  path.string(),
                  0,
                  "",
                  "a file packed as a whole",
                  "one that is expanded: 'unzstd " + path.filename().string() +
                      "', which keeps the packed one",
                  1});
    return nullptr;
  }
  return open_bag(path, problems);
}

}  // namespace

bool is_bag_folder(const fs::path& path) {
  const std::vector<fs::path> files = files_of(path);
  return !files.empty();
}

std::unique_ptr<Bag> open_bag_folder(const fs::path& path, table::DiagnosticGroups& problems) {
  const std::vector<fs::path> files = files_of(path);
  auto bag = std::make_unique<FolderBag>();
  table::DiagnosticGroups of_files;
  for (const fs::path& file : files) {
    if (auto opened = open_file(file, of_files)) {
      bag->add(std::move(opened));
    }
  }
  std::error_code error;
  if (files.size() > 1 && !fs::exists(path / kMetadata, error)) {
    problems.add({Severity::note,
                  path.string(),
                  0,
                  "",
                  std::to_string(files.size()) + " files without metadata.yaml",
                  "the parts of one recording; if each is a trial, name each of them as a source",
                  1});
  }
  // A file less is a recording with a hole; none is no recording.
  for (table::Diagnostic problem : of_files.take()) {
    if (!bag->empty() && problem.severity == Severity::error) {
      problem.severity = Severity::warning;
      problem.expectation += "; the messages of this file are left out";
    }
    problems.add(std::move(problem));
  }
  if (files.empty()) {
    problems.add({Severity::error,
                  path.string(),
                  0,
                  "",
                  "",
                  "a folder of rosbag2, with the .db3 or .mcap files of one recording",
                  1});
  }
  return bag->empty() ? nullptr : std::move(bag);
}

}  // namespace tcert::recording
