#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "datasets/bundle.hpp"
#include "datasets/tick_table.hpp"
#include "datasets/trial_reader.hpp"
#include "reports/series.hpp"
#include "support/c_words.hpp"
#include "support/unix_client.hpp"
#include "support/workdir.hpp"

namespace tcert {
namespace {

namespace fs = std::filesystem;
using test_support::ProcessResult;
using test_support::to_string;
using test_support::Workdir;
using namespace std::chrono_literals;

void expect_done(const ProcessResult& run) { ASSERT_EQ(run.exit_code, 0) << to_string(run); }

template <typename Predicate>
bool eventually(Predicate holds) {
  for (int k = 0; k < 1000; ++k) {
    if (holds()) {
      return true;
    }
    std::this_thread::sleep_for(10ms);
  }
  return false;
}

std::size_t lines_of(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

void send_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::write(descriptor, bytes.data(), bytes.size());
    ASSERT_GT(sent, 0) << std::strerror(errno);
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
}

/// Ticks of a robot that stands still.
std::string still_ticks(const std::string& ticks, std::size_t count) {
  const std::size_t header_end = ticks.find('\n', ticks.find('\n') + 1) + 1;
  const std::string first = ticks.substr(header_end, ticks.find('\n', header_end) - header_end);
  const std::string rest = first.substr(first.find(','));
  std::string text = ticks.substr(0, header_end);
  for (std::size_t k = 0; k < count; ++k) {
    text += std::to_string(k / 10) + "." + std::to_string(k % 10) + rest + "\n";
  }
  return text;
}

/// `tcert live` in a folder with a corpus, its ticks and its series.
class Live : public ::testing::Test {
 protected:
  void prepare(int trials) {
    expect_done(work_.run({"simulate", "--trials", std::to_string(trials), "--output", "corpus"}));
    expect_done(work_.run({"certify", "corpus", "--ticks", "--output", "out"}));
    ticks_ = work_.read("out/ticks/t0000000.csv");
    series_ = work_.read("out/series/t0000000.csv");
  }

  void start(const std::vector<std::string>& options) {
    std::vector<std::string> words{"live", "--bundle", "corpus"};
    words.insert(words.end(), options.begin(), options.end());
    child_ = work_.start(words);
  }

  /// Standard input becomes a pipe that stays open; call before start(), then open_input().
  void make_fifo(const char* name) {
    fs::remove(work_ / name);
    ASSERT_EQ(::mkfifo((work_ / name).c_str(), 0600), 0);
  }

  [[nodiscard]] int connect_unix(const std::string& name) {
    const int descriptor = test_support::connected_to((work_ / name).string());
    EXPECT_GE(descriptor, 0);
    return descriptor;
  }

  int end(int signal) {
    ::kill(child_, signal);
    return wait();
  }

  int wait() {
    int status = 0;
    const bool ended = eventually([&] { return ::waitpid(child_, &status, WNOHANG) == child_; });
    EXPECT_TRUE(ended) << "it does not end";
    if (!ended) {
      ::kill(child_, SIGKILL);
      ::waitpid(child_, &status, 0);
    }
    fs::remove(work_ / ".stdin");  // perhaps a pipe: the next run makes a file of its own
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  [[nodiscard]] std::string out() const { return work_.read(".stdout"); }
  [[nodiscard]] std::string err() const { return work_.read(".stderr"); }
  [[nodiscard]] bool waits_for_lines(std::size_t lines) {
    return eventually([&] { return lines_of(out()) >= lines; });
  }

  [[nodiscard]] std::vector<std::string> hidden() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(work_.path())) {
      if (const std::string name = entry.path().filename().string(); name.ends_with(".tmp")) {
        names.push_back(name);
      }
    }
    return names;
  }

  Workdir work_{TCERT_BINARY};
  std::string ticks_;
  std::string series_;
  pid_t child_ = -1;
};

// The pipe, the C interface and certify: one text.
TEST_F(Live, GivesTheBitsOfCertifyAndOfTheCInterface) {
  prepare(20);
  const BundleResult opened = open_bundle(work_ / "corpus");
  ASSERT_TRUE(opened.bundle);
  const Bundle& bundle = *opened.bundle;
  SeriesFormat format;
  format.synthetic = SyntheticLabel{bundle.info.seed};
  test_support::CSetup setup(bundle.info.robot, bundle.info.course);
  tcert_certifier* certifier = nullptr;
  ASSERT_EQ(setup.create(certifier), TCERT_OK) << setup.message.data();
  std::vector<tcert_reading> readings;
  for (const TrialRow& row : bundle.trials) {
    SCOPED_TRACE(row.trial_id);
    const std::string series = work_.read("out/series/" + row.trial_id + ".csv");
    const ProcessResult live =
        work_.run({"live", "--bundle", "corpus"}, work_.read("out/ticks/" + row.trial_id + ".csv"));
    EXPECT_TRUE(live.out == series);
    const TrialResult trial = read_trial(bundle, row);
    ASSERT_TRUE(trial.log);
    const TickTable ticks = resample(*trial.log);
    tcert_reset(certifier);
    std::string by_c = series_header(format, bundle.info.robot);
    for (std::size_t k = 0; k < ticks.size(); ++k) {
      const tcert_tick tick = test_support::to_c(ticks[k], readings);
      tcert_output now = test_support::empty_output();
      ASSERT_EQ(tcert_update(certifier, &tick, &now), TCERT_OK);
      append_series_row(by_c, ticks[k], test_support::certified(now), {}, format);
    }
    EXPECT_TRUE(by_c == series);
  }
  tcert_destroy(certifier);
}

TEST_F(Live, ARecordCertifiesToTheSameSeries) {
  prepare(2);
  for (const char* file : {"t0000000.csv", "t0000001.csv"}) {
    const ProcessResult live = work_.run({"live",
                                          "--bundle",
                                          "corpus",
                                          "--ray-margins",
                                          "--set",
                                          "body_width_m=0.4",
                                          "--set",
                                          "edge_length_m=0.3",
                                          "--set",
                                          "memory_weight_m=0.031",
                                          "--record",
                                          std::string("record-") + file},
                                         work_.read(std::string("out/ticks/") + file));
    expect_done(live);
    EXPECT_NE(live.err.find("ticks recorded in 'record-"), std::string::npos) << live.err;
    expect_done(work_.run({"check", std::string("record-") + file}));
    expect_done(work_.run({"certify",
                           std::string("record-") + file,
                           "--ray-margins",
                           "--output",
                           std::string("again-") + file}));
    EXPECT_TRUE(work_.read(std::string("again-") + file + "/series/live.csv") == live.out);
  }
  EXPECT_TRUE(hidden().empty());
}

TEST_F(Live, ARecordNeverReplacesAnything) {
  prepare(1);
  const ProcessResult live =
      work_.run({"live", "--bundle", "corpus", "--record", "corpus"}, ticks_);
  EXPECT_EQ(live.exit_code, 73) << to_string(live);
  EXPECT_EQ(live.out, "");
  const ProcessResult none = work_.run({"live", "--bundle", "corpus", "--record", "none"}, "");
  EXPECT_EQ(none.exit_code, 0) << to_string(none);
  EXPECT_FALSE(fs::exists(work_ / "none"));
  EXPECT_TRUE(hidden().empty());
}

TEST_F(Live, ClosesTheRecordWhenItIsTold) {
  prepare(1);
  for (const int signal : {SIGTERM, SIGINT}) {
    make_fifo(".stdin");
    const std::string record = "record" + std::to_string(signal);
    start({"--record", record});
    const int input = ::open((work_ / ".stdin").c_str(), O_WRONLY | O_CLOEXEC);
    ASSERT_GE(input, 0);
    const std::size_t half = ticks_.find('\n', ticks_.size() / 2) + 1;
    send_all(input, std::string_view(ticks_).substr(0, half));
    const std::size_t rows = lines_of(ticks_.substr(0, half)) - 1;  // without the comment
    ASSERT_TRUE(waits_for_lines(rows));
    EXPECT_EQ(end(signal), 0) << err();
    ::close(input);
    EXPECT_TRUE(series_.starts_with(out()));
    expect_done(work_.run({"certify", record, "--output", "again" + record}));
    EXPECT_TRUE(series_.starts_with(work_.read("again" + record + "/series/live.csv")));
    EXPECT_EQ(lines_of(work_.read("again" + record + "/series/live.csv")), rows);
  }
  EXPECT_TRUE(hidden().empty());
}

TEST_F(Live, WhatACrashLeavesCanBeRead) {
  prepare(1);
  make_fifo(".stdin");
  start({"--record", "record"});
  const int input = ::open((work_ / ".stdin").c_str(), O_WRONLY | O_CLOEXEC);
  ASSERT_GE(input, 0);
  send_all(input, ticks_);
  ASSERT_TRUE(waits_for_lines(lines_of(series_)));
  EXPECT_EQ(end(SIGKILL), 128 + SIGKILL);
  ::close(input);
  EXPECT_FALSE(fs::exists(work_ / "record"));
  ASSERT_EQ(hidden().size(), 1U);
  expect_done(work_.run({"certify", hidden()[0], "--output", "again"}));
  EXPECT_TRUE(work_.read("again/series/live.csv") == series_);
}

TEST_F(Live, TakesOneProducerAfterTheOtherOnAUnixSocket) {
  prepare(1);
  start({"--listen", "unix:ticks.socket"});
  const std::size_t header_end = ticks_.find("\n", ticks_.find('\n') + 1) + 1;  // comment, header
  const std::size_t half = ticks_.find('\n', ticks_.size() / 2) + 1;
  const std::size_t first_rows = lines_of(ticks_.substr(0, half)) - 1;
  int socket = connect_unix("ticks.socket");
  send_all(socket, std::string_view(ticks_).substr(0, half));
  send_all(socket, std::string_view(ticks_).substr(half, 7));  // and a line that is cut off
  ::close(socket);
  ASSERT_TRUE(waits_for_lines(first_rows));
  socket = connect_unix("ticks.socket");
  send_all(socket, ticks_.substr(0, header_end) + ticks_.substr(half));
  ASSERT_TRUE(waits_for_lines(lines_of(series_)));
  ::close(socket);
  EXPECT_EQ(end(SIGTERM), 3) << err();
  EXPECT_NE(err().find("listening on unix:ticks.socket"), std::string::npos) << err();
  EXPECT_NE(err().find("1 bad lines"), std::string::npos) << err();
  EXPECT_FALSE(fs::exists(work_ / "ticks.socket"));
  const std::string rows = out();
  ASSERT_EQ(lines_of(rows), lines_of(series_));
  std::size_t at = 0;
  for (std::size_t k = 0; k < first_rows; ++k) {
    at = rows.find('\n', at) + 1;
  }
  EXPECT_EQ(rows.substr(0, at), series_.substr(0, at));
  EXPECT_NE(rows.substr(at, rows.find('\n', at) - at).find("break"), std::string::npos)
      << "a producer that comes back breaks the path";
}

TEST_F(Live, SaysThatTimesGoOnToAProducerWhoseClockBeginsAgain) {
  prepare(1);
  start({"--listen", "unix:ticks.socket"});
  for (int k = 0; k < 2; ++k) {
    const int socket = connect_unix("ticks.socket");
    send_all(socket, still_ticks(ticks_, 3));
    ::close(socket);
    ASSERT_TRUE(waits_for_lines(4));
  }
  EXPECT_TRUE(eventually([&] { return err().find("times go on") != std::string::npos; })) << err();
  EXPECT_EQ(end(SIGTERM), 3) << err();
  EXPECT_EQ(lines_of(out()), 4U);
}

TEST_F(Live, ReplacesAForsakenSocketAndNoOtherFile) {
  prepare(1);
  work_.write("precious.csv", "a,b\n");
  const ProcessResult live =
      work_.run({"live", "--bundle", "corpus", "--listen", "unix:precious.csv"});
  EXPECT_EQ(live.exit_code, 66) << to_string(live);
  EXPECT_NE(live.err.find("in use"), std::string::npos) << live.err;
  EXPECT_EQ(work_.read("precious.csv"), "a,b\n");

  start({"--listen", "unix:ticks.socket"});
  ::close(connect_unix("ticks.socket"));
  EXPECT_EQ(end(SIGKILL), 128 + SIGKILL);
  ASSERT_TRUE(fs::is_socket(work_ / "ticks.socket"));
  start({"--listen", "unix:ticks.socket"});
  ::close(connect_unix("ticks.socket"));
  // Somebody else takes the path meanwhile: theirs stays.
  fs::remove(work_ / "ticks.socket");
  work_.write("ticks.socket", "theirs");
  EXPECT_EQ(end(SIGTERM), 0) << err();
  EXPECT_EQ(work_.read("ticks.socket"), "theirs");
}

TEST_F(Live, GoesOnIgnoringWhatItWasStartedToIgnore) {
  prepare(1);
  make_fifo(".stdin");
  ::signal(SIGHUP, SIG_IGN);  // as nohup does; the child inherits it
  start({});
  ::signal(SIGHUP, SIG_DFL);
  const int input = ::open((work_ / ".stdin").c_str(), O_WRONLY | O_CLOEXEC);
  ASSERT_GE(input, 0);
  const std::size_t half = ticks_.find('\n', ticks_.size() / 2) + 1;
  send_all(input, std::string_view(ticks_).substr(0, half));
  ASSERT_TRUE(waits_for_lines(lines_of(ticks_.substr(0, half)) - 1));
  ::kill(child_, SIGHUP);
  send_all(input, std::string_view(ticks_).substr(half));
  ::close(input);
  EXPECT_EQ(wait(), 0) << err();
  EXPECT_TRUE(out() == series_);
}

TEST_F(Live, TakesDatagramsOnLoopback) {
  prepare(1);
  start({"--listen", "udp:0"});
  const std::string said = "udp:127.0.0.1:";
  ASSERT_TRUE(
      eventually([&] { return err().find(said) != std::string::npos && err().ends_with("\n"); }));
  const std::string text = err();
  const auto port = std::stoul(text.substr(text.find(said) + said.size()));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  std::size_t sent = 0;
  for (std::size_t at = 0; at < ticks_.size();) {
    const std::size_t feed = ticks_.find('\n', at);
    ASSERT_GT(::sendto(socket,
                       ticks_.data() + at,
                       feed - at,  // a datagram needs no line feed
                       0,
                       reinterpret_cast<const sockaddr*>(&address),
                       sizeof address),
              0);
    at = feed + 1;
    if (++sent % 50 == 0) {
      ASSERT_TRUE(waits_for_lines(sent - 1));
    }
  }
  ::close(socket);
  ASSERT_TRUE(waits_for_lines(lines_of(series_)));
  EXPECT_EQ(end(SIGTERM), 0) << err();
  EXPECT_TRUE(out() == series_);
}

TEST_F(Live, DropsRowsAndNeverTicksForASlowConsumer) {
  prepare(1);
  constexpr std::size_t kCount = 20'000;
  make_fifo(".stdout");
  start({"--listen", "unix:ticks.socket", "--record", "record"});
  const int unread = ::open((work_ / ".stdout").c_str(), O_RDONLY | O_CLOEXEC);
  const int socket = connect_unix("ticks.socket");
  send_all(socket, still_ticks(ticks_, kCount));
  ::close(socket);
  // All ticks are taken although nobody reads: the last one is in the record.
  ASSERT_TRUE(eventually([&] {
    const auto names = hidden();
    return !names.empty() && lines_of(work_.read(names[0] + "/logs/live/ticks.csv")) == kCount + 2;
  })) << err();
  // Whoever reads takes some pages more, which end in the middle of a row, and then no more.
  std::string pages(3 * 4096, '\0');
  ASSERT_EQ(::read(unread, pages.data(), pages.size()), static_cast<ssize_t>(pages.size()));
  EXPECT_EQ(end(SIGTERM), 0) << err();
  ::close(unread);
  EXPECT_NE(err().find("rows were dropped"), std::string::npos) << err();
  EXPECT_NE(err().find("the last row was cut off"), std::string::npos) << err();
  EXPECT_NE(err().find("20000 ticks recorded"), std::string::npos) << err();
  fs::remove(work_ / ".stdout");
}

TEST_F(Live, WaitsForASlowConsumerOfAPipeAndStillEndsWhenTold) {
  prepare(1);
  make_fifo(".stdout");
  work_.write(".stdin", still_ticks(ticks_, 20'000));
  start({});
  const int reader = ::open((work_ / ".stdout").c_str(), O_RDONLY | O_CLOEXEC);
  std::this_thread::sleep_for(200ms);
  std::string rows(1 << 20, '\0');
  ASSERT_GT(::read(reader, rows.data(), rows.size()), 0);
  EXPECT_EQ(end(SIGTERM), 0) << err();
  ::close(reader);
  fs::remove(work_ / ".stdout");
}

TEST_F(Live, SaysWhenTheProducerStalls) {
  prepare(1);
  make_fifo(".stdin");
  start({"--stale-after", "0.2"});
  const int input = ::open((work_ / ".stdin").c_str(), O_WRONLY | O_CLOEXEC);
  const std::string still = still_ticks(ticks_, 2);
  const std::size_t last = still.rfind('\n', still.size() - 2) + 1;
  send_all(input, still.substr(0, last));
  EXPECT_TRUE(eventually([&] { return err().find("stale: no tick for") != std::string::npos; }));
  EXPECT_EQ(err().find("ticks again"), std::string::npos);
  send_all(input, still.substr(last));
  EXPECT_TRUE(eventually([&] { return err().find("ticks again, after") != std::string::npos; }));
  ::close(input);
  EXPECT_EQ(wait(), 0) << err();
  EXPECT_EQ(lines_of(out()), 3U);
}

/// The row at `from` of ticks.csv with another time.
std::string at_time(const std::string& ticks, std::size_t from, const std::string& time_s) {
  const std::size_t comma = ticks.find(',', from);
  return time_s + ticks.substr(comma, ticks.find('\n', from) + 1 - comma);
}

TEST_F(Live, OneStampFarAheadCostsItsOwnTickAlone) {
  prepare(1);
  const std::size_t half = ticks_.find('\n', ticks_.size() / 2) + 1;
  for (const char* const time_s : {"100000", "1e9", "9000"}) {
    const ProcessResult live =
        work_.run({"live", "--bundle", "corpus"},
                  ticks_.substr(0, half) + at_time(ticks_, half, time_s) + ticks_.substr(half));
    EXPECT_EQ(live.exit_code, 3) << live.err;
    EXPECT_NE(live.err.find("which the next tick does not confirm"), std::string::npos) << live.err;
    EXPECT_NE(live.err.find("1 bad lines"), std::string::npos) << live.err;
    EXPECT_TRUE(live.out == series_) << time_s;
  }
}

TEST_F(Live, ATrueGapIsConfirmedByTheNextTickAndLosesNone) {
  prepare(1);
  const std::size_t half = ticks_.find('\n', ticks_.size() / 2) + 1;
  const std::size_t next = ticks_.find('\n', half) + 1;
  const std::string gap = ticks_.substr(0, half) + at_time(ticks_, half, "5000");
  const std::size_t comments = lines_of(ticks_) - lines_of(series_);
  ProcessResult live = work_.run({"live", "--bundle", "corpus"}, gap);
  EXPECT_EQ(live.exit_code, 0) << live.err;
  EXPECT_EQ(lines_of(live.out) + comments, lines_of(gap)) << "the last tick of all waits for none";
  const std::string on = gap + at_time(ticks_, next, "5000.1");
  live = work_.run({"live", "--bundle", "corpus"}, on);
  EXPECT_EQ(live.exit_code, 0) << live.err;
  EXPECT_EQ(lines_of(live.out) + comments, lines_of(on));
  std::istringstream rows(live.out.substr(live.out.rfind('\n', live.out.size() - 2) + 1));
  std::string last;
  std::getline(rows, last);
  EXPECT_EQ(last.find("break"), std::string::npos) << "the gap broke the path once: " << last;
}

TEST_F(Live, SkipsAndCountsALineThatNeverEnds) {
  prepare(1);
  const std::size_t half = ticks_.find('\n', ticks_.size() / 2) + 1;
  const ProcessResult live =
      work_.run({"live", "--bundle", "corpus"},
                ticks_.substr(0, half) + std::string(3 << 20, '7') + "\n" + ticks_.substr(half));
  EXPECT_EQ(live.exit_code, 3) << live.err;
  EXPECT_NE(live.err.find("a line of more than 1 MiB"), std::string::npos) << live.err;
  EXPECT_NE(live.err.find("1 bad lines"), std::string::npos) << live.err;
  EXPECT_TRUE(live.out == series_);
}

TEST_F(Live, SaysOnlyTheFirstOfManyBadLines) {
  prepare(1);
  std::string rubbish;
  for (int k = 0; k < 5000; ++k) {
    rubbish += "rubbish\n";
  }
  const ProcessResult live = work_.run({"live", "--bundle", "corpus"}, ticks_ + rubbish);
  EXPECT_EQ(live.exit_code, 3);
  EXPECT_LT(lines_of(live.err), 210U);
  EXPECT_NE(live.err.find("5000 bad lines"), std::string::npos) << live.err;
  EXPECT_TRUE(live.out == series_);
}

TEST_F(Live, TakesADecimalComma) {
  prepare(1);
  std::string with_commas = ticks_.substr(ticks_.find('\n') + 1);
  for (char& c : with_commas) {
    c = c == ',' ? ';' : c == '.' ? ',' : c;
  }
  const ProcessResult live =
      work_.run({"live", "--bundle", "corpus", "--decimal-comma"}, with_commas);
  expect_done(live);
  EXPECT_TRUE(live.out == series_);
}

TEST_F(Live, RefusesWhatItCannotListenOn) {
  prepare(1);
  for (const char* where : {"tcp:80", "udp:70000", "udp:x", "unix:"}) {
    EXPECT_EQ(work_.run({"live", "--bundle", "corpus", "--listen", where}).exit_code, 2) << where;
  }
  EXPECT_EQ(work_.run({"live", "--bundle", "corpus", "--listen", "unix:no/such/socket"}).exit_code,
            66);
  EXPECT_EQ(work_.run({"live", "--bundle", "corpus", "--slow-consumer", "often"}).exit_code, 2);
}

TEST(Interrupt, ACommandThatIsInterruptedLeavesNothingBehind) {
  for (const int signal : {SIGINT, SIGTERM}) {
    Workdir work(TCERT_BINARY);
    const pid_t child = work.start({"simulate", "--trials", "100000", "--output", "corpus"});
    const auto entries = [&] {
      std::size_t count = 0;
      for (const auto& entry : fs::directory_iterator(work.path())) {
        count += entry.path().filename().string().find("corpus") != std::string::npos ? 1 : 0;
      }
      return count;
    };
    ASSERT_TRUE(eventually([&] { return entries() == 1; }));
    std::this_thread::sleep_for(100ms);
    ::kill(child, signal);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), signal);
    EXPECT_EQ(entries(), 0U);
  }
}

}  // namespace
}  // namespace tcert
