#pragma once
/// \file
/// Bytes that no text has: a file that was cut off or overwritten. Internal to check_csv.cpp.

#include <string>
#include <string_view>
#include <table/diagnostic.hpp>

namespace tcert::table {

void find_control_bytes(std::string_view text, const std::string& file, DiagnosticGroups& problems);

}  // namespace tcert::table
