// Formulas of Cox models: contrasts without intercept and products with strata(). The reference is
// coxph() of survival 3.5-3 (R 4.2.2, eps 1e-14) on the same rows: names, coefficients,
// likelihoods.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <statistics/cox/cox.hpp>
#include <statistics/model/model_frame.hpp>
#include <string>
#include <vector>

#include "support/data_table.hpp"

namespace tcert::statistics {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

constexpr const char* kTrials =
    "time,ev,x,alg,lab,arm\n"
    "0.81,1,-2,M1,b,1\n"
    "7,1,0.5,M1,a,2\n"
    "0.03,1,1.7,M7,a,1\n"
    "4.21,1,-0.8,M1,b,1\n"
    "2.47,1,-1.1,M1,b,1\n"
    "0.86,1,-0.6,M1,b,1\n"
    "0.1,0,0.8,M3,a,2\n"
    "1.29,1,0.5,M3,a,1\n"
    "0.48,1,-0.1,M7,a,1\n"
    "0.16,1,-0.8,M1,b,2\n"
    "0.81,0,0.2,M7,a,1\n"
    "0.84,1,1.1,M3,a,1\n"
    "1.16,1,0.2,M7,a,2\n"
    "1.1,1,-0.7,M3,b,1\n"
    "2.79,1,0.5,M7,a,1\n"
    "1.4,1,-1.1,M1,b,2\n"
    "1.3,0,0.4,M7,a,2\n"
    "0.02,1,-0.1,M1,b,2\n"
    "1.01,1,0.3,M1,a,1\n"
    "1.35,1,-0.6,M1,a,1\n"
    "2.02,1,-0.9,M3,b,2\n"
    "0.64,1,2.3,M1,a,1\n"
    "0.29,1,-0.6,M1,b,2\n"
    "0.81,1,-1.3,M7,a,2\n"
    "2.75,1,0.5,M7,a,2\n"
    "0.73,1,-0.9,M1,a,1\n"
    "2.93,1,-1.5,M1,a,2\n"
    "0.93,1,1.2,M1,b,2\n"
    "0.29,1,-1,M7,b,1\n"
    "4.54,1,0.9,M7,b,2\n"
    "0.02,1,-0.5,M7,b,2\n"
    "0.21,1,0.5,M7,a,2\n"
    "0.86,1,-0.4,M3,b,2\n"
    "0.99,1,1.3,M1,a,2\n"
    "1.7,1,-1.1,M7,b,2\n"
    "0.2,0,1.4,M3,a,1\n"
    "1.47,1,-0.6,M3,b,2\n"
    "0.51,1,-0.4,M3,a,1\n"
    "1.79,0,0.2,M7,b,2\n"
    "0.17,1,0.6,M3,a,2\n"
    "0.51,1,-0.1,M1,b,2\n"
    "1.86,1,-2.1,M1,b,2\n"
    "2.92,1,0.6,M1,b,2\n"
    "0.25,1,0.5,M1,b,1\n"
    "0.38,0,-1,M3,b,2\n"
    "0.84,1,1.3,M1,a,2\n"
    "0.2,1,1.1,M7,a,1\n"
    "1.03,1,0.8,M3,a,1\n";

struct Reference {
  const char* formula;
  std::vector<std::string> names;
  std::vector<double> coefficients;  ///< NaN where R has NA.
  double loglik;
};

const std::vector<Reference>& references() {
  static const std::vector<Reference> all{
      {"Surv(time, ev) ~ x * strata(alg)",
       {"x", "x:strata(alg)M3", "x:strata(alg)M7"},
       {0.129338123755, 0.711525642182, -0.469772193002},
       -79.342660200307},
      {"Surv(time, ev) ~ x:strata(alg)",
       {"x:strata(alg)M1", "x:strata(alg)M3", "x:strata(alg)M7"},
       {0.129338123755, 0.840863765937, -0.340434069247},
       -79.342660200307},
      {"Surv(time, ev) ~ x + x:strata(alg)",
       {"x", "x:strata(alg)M3", "x:strata(alg)M7"},
       {0.129338123755, 0.711525642182, -0.469772193002},
       -79.342660200307},
      {"Surv(time, ev) ~ strata(alg) * x",
       {"x", "strata(alg)M3:x", "strata(alg)M7:x"},
       {0.129338123755, 0.711525642182, -0.469772193002},
       -79.342660200307},
      {"Surv(time, ev) ~ lab * strata(alg)",
       {"labb", "labb:strata(alg)M3", "labb:strata(alg)M7"},
       {0.397215001305, -1.77653680314, -0.882282469378},
       -78.913119051249},
      {"Surv(time, ev) ~ lab:strata(alg)",
       {"laba:strata(alg)M1",
        "labb:strata(alg)M1",
        "laba:strata(alg)M3",
        "labb:strata(alg)M3",
        "laba:strata(alg)M7",
        "labb:strata(alg)M7"},
       {-0.397215001305, kNaN, 1.37932180183, kNaN, 0.485067468073, kNaN},
       -78.913119051249},
      {"Surv(time, ev) ~ x * strata(arm)",
       {"x", "x:strata(arm)arm=2"},
       {0.35007549358, -0.443848316204},
       -92.912288869334},
      {"Surv(time, ev) ~ x * strata(alg, lab)",
       {"x",
        "x:strata(alg, lab)M1, b",
        "x:strata(alg, lab)M3, a",
        "x:strata(alg, lab)M3, b",
        "x:strata(alg, lab)M7, a",
        "x:strata(alg, lab)M7, b"},
       {0.478375612927,
        -0.395347170194,
        -1.13944399064,
        8.895137333,
        0.0403200234353,
        -1.93388117113},
       -53.836948577861},
      {"Surv(time, ev) ~ x * strata(lab, arm)",
       {"x",
        "x:strata(lab, arm)lab=a, arm=2",
        "x:strata(lab, arm)lab=b, arm=1",
        "x:strata(lab, arm)lab=b, arm=2"},
       {0.394328838489, -0.234956209692, 0.226824092796, -0.685028254049},
       -68.419626982838},
      {"Surv(time, ev) ~ x * strata(alg) + strata(lab)",
       {"x", "x:strata(alg)M3", "x:strata(alg)M7"},
       {0.217585704962, -0.321821949951, -0.504891169727},
       -57.195542747230},
      {"Surv(time, ev) ~ (x + lab) * strata(alg)",
       {"x",
        "labb",
        "x:strata(alg)M3",
        "x:strata(alg)M7",
        "labb:strata(alg)M3",
        "labb:strata(alg)M7"},
       {0.210914822141,
        0.542024266729,
        -0.235453015677,
        -0.647089669037,
        -1.95332978247,
        -1.16037677557},
       -78.044345030293},
      {"Surv(time, ev) ~ x * strata(alg) * strata(lab)",
       {"x",
        "x:strata(alg)M3",
        "x:strata(alg)M7",
        "x:strata(lab)b",
        "strata(alg)M3:strata(lab)b",
        "strata(alg)M7:strata(lab)b",
        "x:strata(alg)M3:strata(lab)b",
        "x:strata(alg)M7:strata(lab)b"},
       {0.478375612927,
        -1.13944399064,
        0.0403200234353,
        -0.395347170194,
        kNaN,
        kNaN,
        10.4299284938,
        -1.57885402437},
       -53.836948577861},
      {"Surv(time, ev) ~ x * strata(alg) - x",
       {"x:strata(alg)M1", "x:strata(alg)M3", "x:strata(alg)M7"},
       {0.129338123755, 0.840863765937, -0.340434069247},
       -79.342660200307},
      {"Surv(time, ev) ~ strata(alg)/x",
       {"strata(alg)M1:x", "strata(alg)M3:x", "strata(alg)M7:x"},
       {0.129338123755, 0.840863765937, -0.340434069247},
       -79.342660200307},
      {"Surv(time, ev) ~ lab + x - 1",
       {"labb", "x"},
       {-0.048578213134, 0.0423057414902},
       -121.012781014535},
      {"Surv(time, ev) ~ 0 + alg",
       {"algM3", "algM7"},
       {0.271032125555, -0.046163172061},
       -120.799869262613},
      {"Surv(time, ev) ~ alg:lab + x - 1",
       {"x", "algM1:laba", "algM3:laba", "algM7:laba", "algM1:labb", "algM3:labb", "algM7:labb"},
       {0.0451323978967,
        0.154543817917,
        1.0396714408,
        0.60596192221,
        0.629276735122,
        0.446978625402,
        kNaN},
       -119.405427139652},
      {"Surv(time, ev) ~ alg:x + 0",
       {"algM1:x", "algM3:x", "algM7:x"},
       {0.131231666183, 0.315052404582, -0.379690524766},
       -120.228860667031},
      {"Surv(time, ev) ~ x * lab - 1",
       {"x", "labb", "x:labb"},
       {0.306946416736, -0.0655338014009, -0.475845325513},
       -120.227751805079},
  };
  return all;
}

TEST(CoxFormula, HasTheRowsAndTheNumbersOfCoxph) {
  const table::DataTable table = test_support::table_of(kTrials);
  for (const Reference& reference : references()) {
    const ModelFrame frame = model_frame(parse_formula(reference.formula), table);
    const CoxFit fit = fit_cox(cox_data(frame));
    ASSERT_EQ(fit.coefficients.size(), reference.names.size()) << reference.formula;
    EXPECT_NEAR(fit.loglik.value(), reference.loglik, 1e-9) << reference.formula;
    for (std::size_t k = 0; k < reference.names.size(); ++k) {
      const CoxCoefficient& coefficient = fit.coefficients[k];
      EXPECT_EQ(coefficient.column, reference.names[k]) << reference.formula;
      const bool is_na = std::isnan(reference.coefficients[k]);
      ASSERT_EQ(!coefficient.estimate.has_value(), is_na)
          << reference.formula << reference.names[k];
      if (!is_na) {
        EXPECT_NEAR(*coefficient.estimate,
                    reference.coefficients[k],
                    1e-7 * (1.0 + std::abs(reference.coefficients[k])))
            << reference.formula << ' ' << reference.names[k];
      }
    }
  }
}

TEST(CoxFormula, StrataHaveNoTermOfTheirOwn) {
  const table::DataTable table = test_support::table_of(kTrials);
  const ModelFrame frame = model_frame(parse_formula("Surv(time, ev) ~ x * strata(alg)"), table);
  EXPECT_EQ(frame.terms, (std::vector<std::string>{"x", "x:strata(alg)"}));
  EXPECT_EQ(frame.term_of, (std::vector<std::size_t>{0, 1, 2, 2}));
  EXPECT_EQ(frame.strata->levels, (std::vector<std::string>{"M1", "M3", "M7"}));
  FrameOptions options;
  options.reference["alg"] = "M7";
  EXPECT_EQ(model_frame(parse_formula("Surv(time, ev) ~ x * strata(alg)"), table, options).columns,
            (std::vector<std::string>{"(Intercept)", "x", "x:strata(alg)M1", "x:strata(alg)M3"}));
}

TEST(CoxFormula, MissingStrataAreCountedOnce) {
  const ModelFrame frame =
      model_frame(parse_formula("Surv(t, s) ~ x * strata(g)"),
                  test_support::table_of("t,s,x,g\n1,1,1,a\n2,1,2,NA\n3,1,2,b\n4,1,0,a\n"));
  ASSERT_EQ(frame.missing.size(), 1U);
  EXPECT_EQ(frame.missing[0].first, "g");
  EXPECT_EQ(frame.dropped, 1U);
}

TEST(CoxFormula, GroupsTakeNoProductWithStrata) {
  FrameOptions options;
  options.right_side = RightSide::groups;
  EXPECT_THROW(static_cast<void>(model_frame(parse_formula("Surv(time, ev) ~ lab * strata(alg)"),
                                             test_support::table_of(kTrials),
                                             options)),
               FormulaError);
}

}  // namespace
}  // namespace tcert::statistics
