#include <statistics/model/formula.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tcert::statistics {
namespace {

using Names = std::vector<std::string>;

Names terms_of(const std::string& text) {
  Names names;
  for (const Term& term : parse_formula(text).terms) {
    names.push_back(term.name());
  }
  return names;
}

std::string problem_of(const std::string& text) {
  try {
    static_cast<void>(parse_formula(text));
  } catch (const FormulaError& error) {
    return error.what();
  }
  return "no problem";
}

TEST(Formula, ExpandsTermsInRsOrder) {
  EXPECT_EQ(terms_of("y ~ a*b"), (Names{"a", "b", "a:b"}));
  EXPECT_EQ(terms_of("y ~ a:b + a"), (Names{"a", "a:b"}));
  EXPECT_EQ(terms_of("y ~ b:a + a"), (Names{"a", "b:a"}));
  EXPECT_EQ(terms_of("y ~ a*b*c"), (Names{"a", "b", "c", "a:b", "a:c", "b:c", "a:b:c"}));
  EXPECT_EQ(terms_of("y ~ (a + b):c"), (Names{"a:c", "b:c"}));
  EXPECT_EQ(terms_of("y ~ a/b"), (Names{"a", "a:b"}));
  EXPECT_EQ(terms_of("y ~ (a + b + c)^2 - a:b"), (Names{"a", "b", "c", "a:c", "b:c"}));
  EXPECT_EQ(terms_of("y ~ a + a + b - a"), (Names{"b"}));
  EXPECT_EQ(terms_of("y ~ x1 * lighting + x2"), (Names{"x1", "lighting", "x2", "x1:lighting"}));
}

TEST(Formula, KeepsCallsAsVariables) {
  EXPECT_EQ(terms_of("y ~ I(x^2) + log( x ) + scale(x) + factor(day) + I(-x) + I(a/b - 1.5)"),
            (Names{"I(x^2)", "log(x)", "scale(x)", "factor(day)", "I(-x)", "I(a/b - 1.5)"}));
  EXPECT_EQ(to_string(parse_formula("Surv(time,status==2)~ph.ecog").response),
            "Surv(time, status == 2)");
  EXPECT_EQ(to_string(parse_formula("cbind(k, n-k) ~ `odd name`").response), "cbind(k, n - k)");
  EXPECT_EQ(terms_of("y ~ `odd name`"), (Names{"`odd name`"}));
}

TEST(Formula, InterceptGoesAndComes) {
  EXPECT_TRUE(parse_formula("y ~ x").intercept);
  EXPECT_TRUE(parse_formula("y ~ 1").intercept);
  EXPECT_FALSE(parse_formula("y ~ x - 1").intercept);
  EXPECT_FALSE(parse_formula("y ~ 0 + x").intercept);
  EXPECT_FALSE(parse_formula("y ~ -1 + x").intercept);
  EXPECT_TRUE(parse_formula("y ~ 0 + x + 1").intercept);
}

TEST(Formula, TakesSpecialsOut) {
  const Formula formula = parse_formula(
      "Surv(start, stop, event) ~ x + offset(o) + strata(s, t) + cluster(id) + (1 | day/run)");
  ASSERT_EQ(formula.terms.size(), 1U);
  EXPECT_EQ(to_string(formula.offsets.at(0)), "o");
  EXPECT_EQ(formula.strata.size(), 2U);
  EXPECT_EQ(to_string(formula.clusters.at(0)), "id");
  ASSERT_EQ(formula.random_terms.size(), 2U);
  EXPECT_EQ(to_string(formula.random_terms[0].group), "day");
  EXPECT_EQ(to_string(formula.random_terms[1].group), "run:day");
  EXPECT_EQ(formula.columns(),
            (Names{"start", "stop", "event", "x", "o", "s", "t", "id", "day", "run"}));
}

TEST(Formula, TakesRandomTerms) {
  const auto terms_of = [](const char* text) {
    std::vector<std::string> words;
    for (const RandomTerm& random : parse_formula(text).random_terms) {
      std::string word = random.intercept ? "1" : "0";
      for (const Term& term : random.terms) {
        word += "+" + term.name();
      }
      words.push_back(word + "|" + to_string(random.group));
    }
    return words;
  };
  EXPECT_EQ(terms_of("y ~ z + (x | g)"), (Names{"1+x|g"}));
  EXPECT_EQ(terms_of("y ~ (0 + x | g) + (1 | h)"), (Names{"0+x|g", "1|h"}));
  EXPECT_EQ(terms_of("y ~ (1 + x || g)"), (Names{"1|g", "0+x|g"}));
  EXPECT_EQ(terms_of("y ~ (x * z | a/b)"), (Names{"1+x+z+x:z|a", "1+x+z+x:z|b:a"}));
  EXPECT_EQ(parse_formula("y ~ z + (x | g)").columns(), (Names{"y", "z", "x", "g"}));
  EXPECT_TRUE(parse_formula("y ~ 0 + z + (1 | g)").random_terms.front().intercept);
}

TEST(Formula, ReadsNumbersByRsPrecedence) {
  const Expression power = parse_expression("-x^2");
  EXPECT_TRUE(power.is_call("-"));
  EXPECT_EQ(to_string(parse_expression("a - b - c").arguments[0]), "a - b");
  EXPECT_EQ(to_string(parse_expression("a^b^c").arguments[1]), "b^c");
  EXPECT_EQ(parse_expression("1e-3").value, 1e-3);
  EXPECT_EQ(parse_expression(".5").value, 0.5);
  EXPECT_EQ(parse_expression("light == 'Dark'").arguments[1].name, "Dark");
}

TEST(Formula, StrataLeaveTheTermsAndStayInProducts) {
  const Formula formula = parse_formula("Surv(t, s) ~ x * strata(a, b) + strata(c) - 1");
  EXPECT_TRUE(formula.intercept) << "a Cox model has none to drop";
  EXPECT_FALSE(parse_formula("y ~ x - 1").intercept);
  ASSERT_EQ(formula.terms.size(), 2U);
  EXPECT_EQ(formula.terms[1].name(), "x:strata(a, b)");
  EXPECT_EQ(formula.strata.size(), 3U);
  EXPECT_EQ(formula.strata_effects.size(), 2U);
  EXPECT_EQ(formula.columns(), (std::vector<std::string>{"t", "s", "x", "a", "b", "c"}));
  EXPECT_TRUE(parse_formula("Surv(t, s) ~ x + strata(a) - strata(a)").strata.empty());
  EXPECT_EQ(problem_of("y ~ (1 + strata(a) | g)"),
            "formula 'y ~ (1 + strata(a) | g)': '1 + strata(a)' are no random effects: write (1 | "
            "group) or (1 + x | group)");
}

TEST(Formula, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(problem_of("success"),
            "formula 'success': expected outcome ~ terms, for instance success ~ x1 + x2");
  EXPECT_EQ(problem_of("y ~ x +"), "formula 'y ~ x +': it ends too early at character 8");
  EXPECT_EQ(problem_of("y ~ x ; z"), "formula 'y ~ x ; z': unexpected ';' at character 7");
  EXPECT_EQ(problem_of("y ~ log(x"), "formula 'y ~ log(x': expected ',' or ')' at character 10");
  EXPECT_EQ(problem_of("y ~ (0 | day)"),
            "formula 'y ~ (0 | day)': '0' are no random effects: write (1 | group) or (1 + x | "
            "group)");
  EXPECT_EQ(problem_of("y ~ -x"), "formula 'y ~ -x': nothing to take 'x' from; for -x write I(-x)");
  EXPECT_EQ(
      problem_of("y ~ 2*x"),
      "formula 'y ~ 2*x': a number on the right-hand side is 0 or 1; arithmetic goes into I()");
  EXPECT_NE(problem_of(std::string(5000, '(')), "no problem");
}

/// Each operator of a chain is a level of the tree, and walking it takes stack.
TEST(Expression, AChainOfManyOperatorsIsRefused) {
  for (const std::string sign : {" & ", " + ", " - ", " * ", " | "}) {
    std::string chain = "x";
    for (int k = 0; k < 1000; ++k) {
      chain += sign + "x";
    }
    EXPECT_NO_THROW(static_cast<void>(parse_expression(chain)));
    EXPECT_THROW(static_cast<void>(parse_expression(chain + sign + "x")), FormulaError);
  }
  std::string endless = "x";
  for (int k = 0; k < 100'000; ++k) {
    endless += " & x";
  }
  EXPECT_THROW(static_cast<void>(parse_expression("I(" + endless + ")")), FormulaError);
}

TEST(ParseFormula, RefusesInOneLineWhateverTheFormulaHolds) {
  const std::string problem = problem_of("y ~ a\n + \x1B[2J ~ b");
  EXPECT_NE(problem, "no problem");
  EXPECT_EQ(problem.find_first_of("\n\x1B"), std::string::npos) << problem;
}

}  // namespace
}  // namespace tcert::statistics
