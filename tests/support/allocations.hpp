#pragma once
/// \file
/// Counts calls of the global operator new and of malloc in this process.

#include <cstddef>

namespace tcert::test_support {

[[nodiscard]] std::size_t allocation_count() noexcept;

/// Of malloc and its kin, from wherever they are called; always 0 under a sanitizer.
[[nodiscard]] std::size_t malloc_count() noexcept;

}  // namespace tcert::test_support
