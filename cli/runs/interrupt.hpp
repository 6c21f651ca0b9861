#pragma once
/// \file
/// What happens when the process is told to end by SIGINT, SIGTERM or SIGHUP. Those that it was
/// started to ignore (nohup) stay ignored.

namespace tcert::cli {

/// From now on an interrupt first removes what is half written, then ends the process as it would
/// have. To be called once, before there is any other thread.
void watch_interrupts();

/// For a command that ends by itself: the first interrupt only makes this descriptor readable. A
/// second one ends the process at once and leaves files as they are. \throws std::system_error.
[[nodiscard]] int interrupt_descriptor();

}  // namespace tcert::cli
