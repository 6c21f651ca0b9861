// What stands first on the page: findings and the words that they use.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "reports/findings.hpp"
#include "reports/html/findings_json.hpp"
#include "reports/html/glossary.hpp"
#include "reports/html/report_json.hpp"

namespace tcert {
namespace {

TEST(FindingsJson, PutsVerdictsFirstAndKeepsARowWithoutOne) {
  const Table described = findings_table({{"Certificates issued", "", "In 3 of 4."}});
  const Table decided =
      findings_table({{"H1, success", "supported", "AUC 0.8."}, {"H1, time", "contradicted", "C."}},
                     {"Rule of H1."});
  const auto json = findings_json({{"Certificates", "", described}, {"H1", "Is it so?", decided}});
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[0]["title"], "H1");
  EXPECT_EQ(json[0]["question"], "Is it so?");
  EXPECT_EQ(json[0]["lines"][1]["verdict"], "contradicted");
  EXPECT_EQ(json[0]["rules"][0], "Rule of H1.");
  EXPECT_EQ(json[1]["lines"][0]["verdict"], nullptr) << "missing is not a verdict";
  EXPECT_EQ(json[1]["lines"][0]["evidence"], "In 3 of 4.");
}

TEST(FindingsJson, KnowsATableOfAnotherMake) {
  EXPECT_TRUE(is_findings_table(findings_table({})));
  Table other = findings_table({});
  other.columns[2].kind = ColumnKind::number;
  EXPECT_FALSE(is_findings_table(other));
  other.columns.pop_back();
  EXPECT_FALSE(is_findings_table(other));
}

TEST(ResultTitle, SaysWhatAResultIsAndItsFolderWhereThatSaysMore) {
  Result result;
  result.kind = ResultKind::h1;
  result.name = ".";
  EXPECT_EQ(result_title(result), "H1") << "a tree of one folder";
  result.name = "h1";
  EXPECT_EQ(result_title(result), "H1");
  result.name = "narrow";
  EXPECT_EQ(result_title(result), "H1 (narrow)");
  result.kind = ResultKind::other;
  result.name = ".";
  result.manifest.command = "fit cox";
  EXPECT_EQ(result_title(result), "fit cox");
  EXPECT_EQ(result_question(result), "");
}

TEST(HasWord, IsAWholeWord) {
  EXPECT_TRUE(has_word("the C of it", "C"));
  EXPECT_TRUE(has_word("\"C\"", "C"));
  EXPECT_FALSE(has_word("AUC", "C"));
  EXPECT_FALSE(has_word("C_within", "C"));
  EXPECT_TRUE(has_word("AUC, then C", "C"));
  EXPECT_TRUE(has_word("T(E; A) is", "T(E; A)"));
  EXPECT_TRUE(has_word("TD*Lite", "TD*Lite"));
  EXPECT_FALSE(has_word("", "C"));
}

std::set<std::string> terms_of(const std::string& text, bool with_algorithms) {
  std::set<std::string> terms;
  for (const GlossaryEntry& entry : glossary_of(text, with_algorithms)) {
    EXPECT_FALSE(entry.meaning.empty());
    EXPECT_EQ(entry.meaning.back(), '.') << entry.term;
    terms.insert(entry.term);
  }
  return terms;
}

TEST(Glossary, ExplainsWhatThePageSaysAndNothingElse) {
  const std::string text = "AUC of tc_early 0.7 [0.6, 0.8] for M3 and CB-V; T_t";
  EXPECT_EQ(terms_of(text, true),
            (std::set<std::string>{"AUC", "TC_early", "0.7 [0.6, 0.8]", "M3", "CB-V", "T_t"}));
  EXPECT_EQ(terms_of(text, false).count("M3"), 0U) << "somebody else's M3";
  EXPECT_TRUE(terms_of("", true).empty());
}

TEST(ReportJson, HasFindingsAndAGlossaryOfWhatStandsOnThePage) {
  PageContents contents;
  contents.findings = {
      {"H1", "", findings_table({{"H1", "supported", "AUC of tc_landmark 0.8."}})}};
  const auto json = nlohmann::json::parse(report_json(contents));
  EXPECT_EQ(json["findings"][0]["lines"][0]["verdict"], "supported");
  std::set<std::string> terms;
  for (const auto& entry : json["glossary"]) {
    terms.insert(entry[0]);
  }
  // The methods, which every page has, use the rest.
  for (const char* const term : {"AUC", "TC_early", "T_t", "V_t", "m_t", "S, G", "E, A, T(E; A)"}) {
    EXPECT_TRUE(terms.contains(term)) << term;
  }
  EXPECT_FALSE(terms.contains("squash, clip"));
}

}  // namespace
}  // namespace tcert
