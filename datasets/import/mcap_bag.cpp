#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "datasets/import/bag.hpp"
#include "datasets/import/mcap_pass.hpp"
#include "datasets/import/mcap_summary.hpp"
#include "datasets/import/mcap_topics.hpp"

namespace tcert::recording {
namespace {

using table::Severity;

constexpr auto kLatest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());

void say(table::DiagnosticGroups& problems,
         const std::string& file,
         Severity severity,
         std::string found,
         std::string expectation,
         std::size_t count = 1) {
  problems.add({severity, file, 0, "", std::move(found), std::move(expectation), count});
}

class McapBag final : public Bag {
 public:
  explicit McapBag(McapFile file) : file_(std::move(file)) {}

  /// False, with an error, if no message can be read.
  bool open(table::DiagnosticGroups& problems);

  [[nodiscard]] const std::vector<Topic>& topics() const override { return topics_.topics(); }

  void for_each(std::span<const std::size_t> wanted,
                const MessageVisitor& visit,
                table::DiagnosticGroups& problems) override;

 private:
  bool scan(table::DiagnosticGroups& problems);
  void compare_counts(const std::vector<std::size_t>& messages, table::DiagnosticGroups& problems);

  McapFile file_;
  McapTopics topics_;
  bool is_counted_ = false;  // by reading, not by the summary
};

bool McapBag::open(table::DiagnosticGroups& problems) {
  const auto magic = file_.window.at(0, kMcapMagic.size());
  if (!begins_as_mcap({reinterpret_cast<const char*>(magic.data()), magic.size()})) {
    say(problems,
        file_.name,
        Severity::error,
        "",
        "an MCAP file, which begins with the bytes \\x89MCAP0");
    return false;
  }
  std::string problem;
  if (auto summary = mcap_summary(file_.window, problem)) {
    topics_ = std::move(summary->topics);
    return true;
  }
  if (!problem.empty()) {
    say(problems,
        file_.name,
        Severity::warning,
        "a summary section that cannot be used: " + problem,
        "one that holds together; the topics are taken from the messages");
  }
  return scan(problems);
}

/// Learns the topics and their counts by reading the whole file.
bool McapBag::scan(table::DiagnosticGroups& problems) {
  std::vector<std::size_t> of_channel;
  McapHandlers handlers;
  handlers.schema = [this](const SchemaRecord& schema) { topics_.add(schema); };
  handlers.channel = [this](const ChannelRecord& channel) { topics_.add(channel); };
  handlers.message = [&of_channel](const MessageRecord& message) {
    if (message.channel_id >= of_channel.size()) {
      of_channel.resize(std::size_t{message.channel_id} + 1);
    }
    ++of_channel[message.channel_id];
    return true;
  };
  const McapPassEnd end = pass_through(file_, handlers, problems);
  file_.window.release();
  file_.expander.release();
  std::vector<std::size_t> messages(topics_.topics().size());
  std::size_t lost = 0;
  for (std::size_t channel = 0; channel < of_channel.size(); ++channel) {
    const auto topic = topics_.topic_of(static_cast<std::uint16_t>(channel));
    (topic ? messages[*topic] : lost) += of_channel[channel];
  }
  topics_.set_counts(messages);
  is_counted_ = true;
  if (lost > 0) {
    say(problems,
        file_.name,
        Severity::warning,
        "",
        "a channel record for every message; a message without is left out",
        lost);
  }
  if (!end.complete && lost == end.messages) {
    say(problems, file_.name, Severity::error, "", "at least one message that can be read");
    return false;
  }
  return true;
}

void McapBag::for_each(std::span<const std::size_t> wanted,
                       const MessageVisitor& visit,
                       table::DiagnosticGroups& problems) {
  std::vector<char> is_wanted(topics().size(), 0);
  for (const std::size_t topic : wanted) {
    is_wanted.at(topic) = 1;
  }
  std::vector<std::size_t> messages(topics().size());
  std::size_t unlisted = 0;
  std::size_t beyond = 0;
  McapHandlers handlers;
  handlers.message = [&](const MessageRecord& message) {
    const auto topic = topics_.topic_of(message.channel_id);
    if (!topic) {
      ++unlisted;
      return true;
    }
    ++messages[*topic];
    if (is_wanted[*topic] == 0) {
      return true;
    }
    if (message.log_time > kLatest || message.publish_time > kLatest) {
      ++beyond;
      return true;
    }
    return visit({*topic,
                  static_cast<std::int64_t>(message.log_time),
                  static_cast<std::int64_t>(message.publish_time),
                  message.data});
  };
  const McapPassEnd end = pass_through(file_, handlers, problems);
  file_.window.release();
  file_.expander.release();
  if (beyond > 0) {
    say(problems,
        file_.name,
        Severity::warning,
        "",
        "times before the year 2262; a message with another is left out",
        beyond);
  }
  if (!is_counted_ && unlisted > 0) {
    say(problems,
        file_.name,
        Severity::warning,
        "",
        "a summary section that lists every channel ('mcap recover' writes one); a message of "
        "another channel is left out",
        unlisted);
  }
  if (end.complete && !is_counted_) {
    compare_counts(messages, problems);
  }
}

/// Of a file that was read to its end, once.
void McapBag::compare_counts(const std::vector<std::size_t>& messages,
                             table::DiagnosticGroups& problems) {
  for (std::size_t i = 0; i < messages.size(); ++i) {
    if (messages[i] != topics()[i].messages) {
      say(problems,
          file_.name,
          Severity::warning,
          std::to_string(topics()[i].messages) + " messages of " +
              table::shortened(topics()[i].name) + " in the summary section, but " +
              std::to_string(messages[i]) + " in the file",
          "counts that agree; those of the file hold");
    }
  }
  topics_.set_counts(messages);
  is_counted_ = true;
}

}  // namespace

bool begins_as_mcap(std::string_view bytes) noexcept { return bytes.starts_with(kMcapMagic); }

std::unique_ptr<Bag> open_mcap(const std::filesystem::path& path,
                               table::DiagnosticGroups& problems) {
  std::string problem;
  auto window = FileWindow::open(path, problem);
  if (!window) {
    problems.add({Severity::error, path.string(), 0, "", "", "a readable file: " + problem, 1});
    return nullptr;
  }
  auto bag = std::make_unique<McapBag>(McapFile{std::move(*window), path.string()});
  return bag->open(problems) ? std::move(bag) : nullptr;
}

}  // namespace tcert::recording
