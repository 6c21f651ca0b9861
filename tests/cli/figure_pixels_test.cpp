/// Every figure as it looks: drawn by gnuplot, and ink where its numbers are.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <sstream>

#include "cli/figure_ink.hpp"
#include "reports/figure/figures_of.hpp"
#include "reports/figure/trial_figures.hpp"
#include "support/workdir.hpp"

namespace tcert {
namespace {

using test_support::ink_problems;
using test_support::ProcessResult;
using test_support::read_ppm;
using test_support::Workdir;

constexpr double kScale = 2.0;  // Pixels of the picture for each of the layout.

std::string missing_program() {
  Workdir shell("/bin/sh");
  for (const char* const program : {"gnuplot", "rsvg-convert", "pdftoppm"}) {
    if (shell.run({"-c", "command -v " + std::string(program)}).exit_code != 0) {
      return program;
    }
  }
  return "";
}

/// All kinds of results, and the figures of them; made once.
class FigurePixels : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (!missing_program().empty()) {
      return;
    }
    work = std::make_unique<Workdir>(TCERT_BINARY);
    const std::string features = "r/certificates/features.csv";
    const std::vector<std::vector<std::string>> steps = {
        {"simulate", "--trials", "330", "--output", "r/corpus"},
        {"certify", "r/corpus", "--truth", "--output", "r/certificates"},
        {"hypotheses", "h1", "--features", features, "--replicates", "60", "--output", "r/h1/"},
        {"hypotheses", "h2", "--features", features, "--output", "r/h2/"},
        {"replay", "r/corpus", "--output", "r/replays"},
        {"hypotheses", "h3", "--replays", "r/replays/replay.csv", "--output", "r/h3/"},
        {"sweep",
         "r/corpus",
         "--grid",
         "beta_per_m=5,10",
         "--replicates",
         "60",
         "--no-cache",
         "--output",
         "r/sweep"},
        {"ablate", "r/corpus", "--replicates", "60", "--no-cache", "--output", "r/ablation"},
        {"simulate", "--micro-study", "--output", "r/gates"},
        {"gate", "r/gates", "--output", "r/gate/"},
        {"figures", "r", "--output", "f"}};
    for (const auto& step : steps) {
      const ProcessResult run = work->run(step);
      ASSERT_EQ(run.exit_code, 0) << to_string(run);
    }
    const Results results = read_results(work->path() / "r");
    StudyFigures study = study_figures(results);
    figures = std::move(study.figures);
    for (const std::string& trial : typical_trials(results)) {
      const TrialPicture picture = *trial_picture(results, trial);
      figures.push_back(*trial_series_figure(picture));
      figures.push_back(*trial_map_figure(picture));
    }
  }
  static void TearDownTestSuite() {
    work.reset();
    figures.clear();
  }
  void SetUp() override {
    if (const std::string program = missing_program(); !program.empty()) {
      GTEST_SKIP() << program << " is not installed (scripts/setup tests installs it)";
    }
  }

  static const Figure& figure(const std::string& name) {
    return *std::find_if(
        figures.begin(), figures.end(), [&](const Figure& one) { return one.name == name; });
  }

  /// What is wrong with FOLDER/NAME.FORM.
  static std::vector<std::string> problems_of(const Figure& figure,
                                              const std::string& form,
                                              const std::string& folder = "f") {
    Workdir shell("/bin/sh");
    const std::string file = (work->path() / folder / (figure.name + "." + form)).string();
    const std::string pdf =
        form == "pdf" ? "cp '" + file + "' a.pdf" : "rsvg-convert -f pdf '" + file + "' -o a.pdf";
    const ProcessResult run = shell.run({"-c", pdf + " && pdftoppm -r 192 -singlefile a.pdf a"});
    EXPECT_EQ(run.exit_code, 0) << to_string(run);
    return ink_problems(figure, read_ppm(shell / "a.ppm"), kScale);
  }

  /// A copy of the figures that a test may spoil, drawn again by `command`.
  static void draw_again(const std::string& folder, const std::string& command) {
    Workdir shell("/bin/sh");
    const ProcessResult run =
        shell.run({"-c", "cd '" + (work->path() / folder).string() + "' && " + command});
    ASSERT_EQ(run.exit_code, 0) << to_string(run);
  }
  static void copy_to(const std::string& folder) {
    std::filesystem::copy(
        work->path() / "f", work->path() / folder, std::filesystem::copy_options::recursive);
  }

  static std::unique_ptr<Workdir> work;
  static std::vector<Figure> figures;
};

std::unique_ptr<Workdir> FigurePixels::work;
std::vector<Figure> FigurePixels::figures;

TEST_F(FigurePixels, HaveInkWhereTheNumbersAre) {
  std::set<std::string> names;
  for (const Figure& one : figures) {
    names.insert(one.name);
    for (const char* const form : {"svg", "pdf"}) {
      for (const std::string& problem : problems_of(one, form)) {
        ADD_FAILURE() << form << ": " << problem;
      }
    }
  }
  for (const char* const name : {"success_by_quantile",
                                 "early_by_outcome",
                                 "operating_point",
                                 "auc_by_day",
                                 "roc",
                                 "within_strata",
                                 "left_out",
                                 "incidence",
                                 "calibration",
                                 "forest",
                                 "equivalence",
                                 "pareto",
                                 "ablation",
                                 "specification_curve",
                                 "gate",
                                 "speed_by_algorithm",
                                 "speed_by_lighting",
                                 "truth"}) {
    EXPECT_TRUE(names.contains(name)) << name << " is not drawn at all";
  }
  EXPECT_GE(figures.size(), 21U) << "series and map of two trials at least";
}

/// The curves of incidence and their bands, a row of one after a row of the other: gnuplot draws no
/// line from a point to one behind another's row. SVG and PDF were empty; their text did not say.
TEST_F(FigurePixels, SeeThatALineIsTornByRowsBetweenItsOwn) {
  const Figure& incidence = figure("incidence");
  ASSERT_EQ(problems_of(incidence, "svg"), std::vector<std::string>{});
  std::istringstream table(work->read("f/incidence.csv"));
  std::string header;
  std::getline(table, header);
  std::vector<std::string> curve;
  std::vector<std::string> others;
  for (std::string row; std::getline(table, row);) {
    (row.starts_with("curve") ? curve : others).push_back(row);
  }
  std::string torn = header + "\n";
  for (std::size_t i = 0; i < std::max(curve.size(), others.size()); ++i) {
    torn += i < curve.size() ? curve[i] + "\n" : "";
    torn += i < others.size() ? others[i] + "\n" : "";
  }
  copy_to("torn");
  work->write("torn/incidence.csv", torn);
  for (const char* const form : {"svg", "pdf"}) {
    draw_again("torn", std::string("gnuplot -c incidence.gp ") + form);
    const std::vector<std::string> problems = problems_of(incidence, form, "torn");
    EXPECT_GE(problems.size(), 8U) << "four curves and their bands: " << form;
    EXPECT_TRUE(std::any_of(problems.begin(), problems.end(), [](const std::string& problem) {
      return problem.find("part 'curve' Q1 is not drawn") != std::string::npos;
    }));
  }
}

/// A solid line of chance was called dashed.
TEST_F(FigurePixels, SeeThatADashedLineIsSolid) {
  ASSERT_EQ(problems_of(figure("roc"), "svg"), std::vector<std::string>{});
  copy_to("solid");
  draw_again("solid", "sed -i 's/dt (7,8)/dt solid/' roc.gp && gnuplot -c roc.gp svg");
  const std::vector<std::string> problems = problems_of(figure("roc"), "svg", "solid");
  ASSERT_FALSE(problems.empty());
  EXPECT_NE(problems.front().find("part 'chance'  is not interrupted"), std::string::npos)
      << problems.front();
}

}  // namespace
}  // namespace tcert
