#pragma once
/// \file
/// Where ticks come from: standard input, a Unix socket or UDP on loopback.

#include <cstddef>
#include <memory>
#include <string>

namespace tcert::cli {

class Producer {
 public:
  enum class Event {
    bytes,  ///< Some arrived.
    none,   ///< A false alarm.
    came,   ///< A new stream begins.
    left,   ///< The stream ended; another may come.
    end,    ///< There will be no more.
  };

  virtual ~Producer() = default;

  /// Its name in messages: "stdin", "unix:/run/ticks", "udp:127.0.0.1:5005".
  [[nodiscard]] virtual const std::string& name() const = 0;

  /// To wait for; changes with every event.
  [[nodiscard]] virtual int descriptor() const = 0;

  /// Takes what is there, without waiting if descriptor() is readable; `bytes` is replaced.
  /// \throws BadData if it cannot be read.
  virtual Event receive(std::string& bytes) = 0;

  /// Datagrams that the system dropped because they were not taken in time.
  [[nodiscard]] virtual std::size_t lost() const { return 0; }
};

/// Standard input for an empty `where`, else what to listen on: "unix:PATH", one producer after the
/// other, or "udp:PORT" on loopback, port 0 for any that is free.
/// \throws UsageError; NoInput if it cannot be listened on.
[[nodiscard]] std::unique_ptr<Producer> open_producer(const std::string& where);

}  // namespace tcert::cli
