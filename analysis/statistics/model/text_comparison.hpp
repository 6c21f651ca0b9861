#pragma once
/// \file
/// Columns compared with texts: status == "failed". Internal to variable.cpp.

#include <statistics/model/expression.hpp>
#include <statistics/model/variable.hpp>
#include <string>
#include <table/data_table.hpp>
#include <table/factor.hpp>

namespace tcert::statistics {

/// TRUE or FALSE for any spelling of them; other words stay.
[[nodiscard]] std::string truth_word(const std::string& word);

/// Where the factor equals the text, or by != where it does not. A word for a missing cell differs
/// from every text, and would count as one of them; compared with itself it is meant. \throws
/// FormulaError with the place of the first such word.
[[nodiscard]] Variable compared_with_text(const Expression& call,
                                          const table::Factor& factor,
                                          const std::string& text,
                                          const table::DataTable& table);

/// An unquoted word that is no column but a level of the other side lacks its quotes. \throws
/// FormulaError for a comparison with such a word on the right.
void require_known_word(const Expression& comparison, const table::DataTable& table);

}  // namespace tcert::statistics
