#pragma once
/// \file
/// Counts calls of the global operator new in this process.

#include <cstddef>

namespace tcert::test_support {

[[nodiscard]] std::size_t allocation_count() noexcept;

}  // namespace tcert::test_support
