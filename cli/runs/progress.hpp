#pragma once
/// \file
/// Whom a run tells how it goes. Lines have no line feed at the end.

#include <cstddef>
#include <span>
#include <string_view>
#include <table/diagnostic.hpp>

namespace tcert::cli {

class Progress {
 public:
  virtual ~Progress() = default;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// What somebody has to know: what is left out, what is wrong and where.
  virtual void say(std::string_view lines) = 0;
  /// A line each.
  void say(std::span<const table::Diagnostic> diagnostics);
  /// What was done, for those who like to hear it.
  virtual void sum_up(std::string_view lines) = 0;
  /// What was found and goes to no file; empty text is nothing.
  virtual void show(std::string_view text) = 0;
  /// Characters in a line of where it is shown; 0 if there is no end to it.
  [[nodiscard]] virtual std::size_t width() const { return 0; }

 protected:
  Progress() = default;

 private:
  friend class Stage;
  friend class WithoutSums;
  virtual void begin(std::string_view what, std::size_t total) = 0;
  virtual void reach(std::size_t done) = 0;
  virtual void end() = 0;
};

/// Long work of `total` equal parts. One thread at a time, and one stage at a time.
class Stage {
 public:
  Stage(Progress& progress, std::string_view what, std::size_t total);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// One more is done.
  void advance() { reach(done_ + 1); }
  /// So many are done.
  void reach(std::size_t done);

 private:
  Progress& progress_;
  std::size_t done_ = 0;
};

/// Passes on what is to be said, and nothing else: of a run within a run.
class OnlyWords : public Progress {
 public:
  explicit OnlyWords(Progress& to) : to_(to) {}

  using Progress::say;
  void say(std::string_view lines) override { to_.say(lines); }
  void sum_up(std::string_view /*lines*/) override {}
  void show(std::string_view /*text*/) override {}

 private:
  void begin(std::string_view /*what*/, std::size_t /*total*/) override {}
  void reach(std::size_t /*done*/) override {}
  void end() override {}

  Progress& to_;
};

/// Passes on what is to be said and how far it is, not what was found: of a run that shows that
/// itself.
class WithoutSums : public OnlyWords {
 public:
  explicit WithoutSums(Progress& to) : OnlyWords(to), whole_(to) {}

 private:
  void begin(std::string_view what, std::size_t total) override { whole_.begin(what, total); }
  void reach(std::size_t done) override { whole_.reach(done); }
  void end() override { whole_.end(); }

  Progress& whole_;
};

}  // namespace tcert::cli
