#include "reports/figure/figure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <table/bytes.hpp>
#include <table/read_data_table.hpp>

#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_rows.hpp"
#include "reports/figure/figure_table.hpp"
#include "reports/figure/gnuplot.hpp"
#include "reports/figure/gnuplot_layout.hpp"
#include "reports/figure/h1_figures.hpp"
#include "reports/figure/set_figures.hpp"
#include "reports/figure/trial_figures.hpp"
#include "reports/figure/vega_lite.hpp"

namespace tcert {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Figure small_figure() {
  Figure figure;
  figure.name = "small";
  figure.title = "It's small";
  figure.synthetic = SyntheticLabel{3};
  figure.data = figure_table("small", {"who"}, {"x_m", "y_m"});
  add_figure_row(figure.data, "curve", {"a"}, {0.1, 1.0 / 3.0});
  add_figure_row(figure.data, "curve", {"b"}, {0.2, kNaN});
  add_figure_row(figure.data, "curve", {"b"}, {0.3, 0.0});
  figure.key.classes = {"a", "b"};
  Panel panel;
  panel.x.title = "way";
  panel.x.unit = "m";
  panel.y.title = "height";
  panel.y.unit = "m";
  Layer layer;
  layer.mark = Mark::line;
  layer.part = "curve";
  layer.x = "x_m";
  layer.y = "y_m";
  layer.colour = "who";
  panel.layers = {layer};
  figure.panels = {panel};
  return figure;
}

table::DataTable csv_of(const Figure& figure) {
  table::CsvOptions csv;
  csv.file = figure.name;
  return *table::read_data_table(table::Bytes::copy_of(figure_csv(figure)), {}, csv).table;
}

/// Every value behind the specification is the cell of the CSV file, bit for bit.
void expect_same_data(const Figure& figure) {
  const auto spec = vega_lite(figure);
  const table::DataTable csv = csv_of(figure);
  const auto& values = spec["data"]["values"];
  ASSERT_EQ(values.size(), csv.rows);
  for (std::size_t row = 0; row < csv.rows; ++row) {
    for (const auto& [key, value] : values[row].items()) {
      if (value.is_number()) {
        EXPECT_EQ(value.get<double>(), number_at(csv, row, key)) << figure.name << ' ' << key;
      } else if (value.is_string()) {
        EXPECT_EQ(value.get<std::string>(), text_at(csv, row, key)) << figure.name << ' ' << key;
      } else {
        EXPECT_TRUE(value.is_null());
        EXPECT_EQ(text_at(csv, row, key), "") << "missing is not 0: " << figure.name << ' ' << key;
      }
    }
  }
}

TEST(Figure, HasTheSameDataInEveryForm) { expect_same_data(small_figure()); }

TEST(Figure, KeepsWhatIsMissingMissing) {
  EXPECT_EQ(figure_csv(small_figure()),
            "part,who,x_m,y_m,synthetic_seed\n"
            "curve,a,0.1,0.3333333333333333,3\n"
            "curve,b,0.2,,3\n"
            "curve,b,0.3,0,3\n");
}

TEST(Figure, BreaksALineWhereAValueIsMissing) {
  const std::string script = gnuplot_script(small_figure());
  EXPECT_NE(script.find("strcol('y_m') ne ''"), std::string::npos) << script;
  EXPECT_EQ(script.find("datafile missing"), std::string::npos) << "it would go on";
}

TEST(Figure, SaysThatDataAreSynthetic) {
  EXPECT_NE(vega_lite(small_figure())["title"]["subtitle"].get<std::string>().find("SYNTHETIC"),
            std::string::npos);
  EXPECT_NE(gnuplot_script(small_figure()).find("SYNTHETIC"), std::string::npos);
}

TEST(Figure, HasUnitsOnItsAxes) {
  const auto spec = vega_lite(small_figure());
  EXPECT_EQ(spec["layer"][0]["encoding"]["x"]["title"], "way [m]");
  EXPECT_NE(gnuplot_script(small_figure()).find("set ylabel 'height [m]'"), std::string::npos);
}

TEST(Figure, QuotesWhatGnuplotWouldRead) {
  EXPECT_NE(gnuplot_script(small_figure()).find("('It'.\"'\".'s small')"), std::string::npos);
}

/// No line of the script begins with what a text of the figure says.
void expect_nothing_run(const std::string& script) {
  std::istringstream lines(script);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_FALSE(line.starts_with("system(")) << script;
    EXPECT_FALSE(line.starts_with("#") && line.ends_with("\\")) << script;
  }
  EXPECT_EQ(script.find('\r'), std::string::npos);
}

TEST(Figure, RunsNothingThatATextSays) {
  const std::string hostile = "Dark\nsystem('touch pwned')\r\nsystem('x') \\";
  Figure figure = small_figure();
  figure.title = hostile;
  figure.panels[0].title = hostile;
  figure.panels[0].x.title = hostile;
  figure.key.classes[0] = hostile;
  figure.data.rows[0][1] = hostile;
  expect_nothing_run(gnuplot_script(figure));
  make_plain(figure);
  expect_nothing_run(gnuplot_script(figure));
  expect_same_data(figure);
  const std::string csv = figure_csv(figure);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4) << "a row a line: " << csv;
  EXPECT_EQ(csv.find('"'), std::string::npos) << csv;
}

TEST(Figure, IsTheSameForTheSameData) {
  EXPECT_EQ(gnuplot_script(small_figure()), gnuplot_script(small_figure()));
  EXPECT_EQ(vega_lite(small_figure()).dump(), vega_lite(small_figure()).dump());
}

TEST(Figure, RefusesWhatItCannotDraw) {
  Figure no_column = small_figure();
  no_column.panels[0].layers[0].y = "z";
  EXPECT_THROW(check(no_column), std::invalid_argument);
  Figure no_class = small_figure();
  no_class.key.classes = {"a"};
  EXPECT_THROW(check(no_class), std::invalid_argument);
  Figure no_title = small_figure();
  no_title.panels[0].x.title.clear();
  EXPECT_THROW(check(no_title), std::invalid_argument);
}

TEST(ClassColour, IsToldApart) {
  std::set<std::string_view> colours;
  for (std::size_t i = 0; i < 6; ++i) {
    colours.insert(class_colour(i));
  }
  EXPECT_EQ(colours.size(), 6U);
}

TEST(GnuplotLayout, PutsNoPanelOverAnother) {
  Figure figure = small_figure();
  figure.panels.assign(5, figure.panels.front());
  figure.columns = 2;
  figure.panels[2].height = 0.3;
  const FigureLayout layout = gnuplot_layout(figure);
  ASSERT_EQ(layout.boxes.size(), 5U);
  for (std::size_t a = 0; a < 5; ++a) {
    const PanelBox& one = layout.boxes[a];
    EXPECT_GE(one.left, 0.0);
    EXPECT_GE(one.bottom, 0.0);
    EXPECT_LE(one.left + one.width, layout.width);
    EXPECT_LE(one.bottom + one.height, layout.height);
    for (std::size_t b = a + 1; b < 5; ++b) {
      const PanelBox& other = layout.boxes[b];
      const bool apart = one.left + one.width < other.left || other.left + other.width < one.left ||
                         one.bottom > other.bottom + other.height ||
                         other.bottom > one.bottom + one.height;
      EXPECT_TRUE(apart) << a << ' ' << b;
    }
  }
}

TEST(RoundStep, IsRound) {
  EXPECT_EQ(round_step(100.0, 6), 20.0);
  EXPECT_EQ(round_step(7.0, 7), 1.0);
  EXPECT_EQ(round_step(0.9, 3), 0.5);
}

Table roc_table() {
  Table table;
  table.name = "h1_roc";
  table.columns = {{"panel", "", "", ColumnKind::text},
                   {"predictor", "", "", ColumnKind::text},
                   {"threshold", "", "", ColumnKind::number},
                   {"sensitivity", "", "", ColumnKind::number},
                   {"specificity", "", "", ColumnKind::number}};
  const double points[][2] = {{1, 0}, {1, 0.25}, {1, 0.5}, {0.5, 0.5}, {0.25, 1}, {0, 1}};
  for (const auto& point : points) {
    table.add_row({std::string("paper"),
                   std::string("tc_early"),
                   Number{0.0},
                   Number{point[0]},
                   Number{point[1]}});
  }
  return table;
}

TEST(RocFigure, KeepsTheAreaThoughNotEveryPoint) {
  const Figure figure = *roc_figure(roc_table());
  double area = 0.0;
  double x = kNaN;
  double y = kNaN;
  std::size_t points = 0;
  for (std::size_t row = 0; row < figure.data.rows.size(); ++row) {
    if (text_at(figure.data, row, "part") != "curve") {
      continue;
    }
    const double to_x = number_at(figure.data, row, "false_success_share");
    const double to_y = number_at(figure.data, row, "success_share");
    if (points++ > 0) {
      area += (x - to_x) * (y + to_y) / 2.0;
    }
    x = to_x;
    y = to_y;
  }
  EXPECT_EQ(points, 5U);
  EXPECT_DOUBLE_EQ(area, 0.5 + 0.5 * 0.375);
  expect_same_data(figure);
}

TEST(PredictorLabel, KnowsBothPanels) {
  EXPECT_EQ(predictor_label("tc_early"), "TC_early");
  EXPECT_EQ(predictor_label("tc_landmark"), "TC_early");
  EXPECT_EQ(predictor_label("contacts_per_m_landmark"), "contacts per metre");
  EXPECT_EQ(predictor_label("rivals + tc_landmark"), "rivals + TC_early");
  EXPECT_EQ(predictor_label("m1"), "m1");
}

TEST(SetFigures, TheCaptionHasTheIntervalOfTheTable) {
  Table cells;
  cells.columns = {{"cell", "cell", "", ColumnKind::text},
                   {"panel", "panel", "", ColumnKind::text},
                   {"auc", "AUC [90 % expanded]", "", ColumnKind::estimate}};
  cells.add_row({std::string("full"), std::string("paper"), Estimate{0.8, 0.7, 0.9}});
  const std::string sorted = cells_figure(cells, "ablation", "Parts left out").value().caption;
  EXPECT_NE(sorted.find("with 90 % expanded intervals, sorted."), std::string::npos) << sorted;
  EXPECT_EQ(sorted.find("BCa"), std::string::npos);

  Table h3;
  h3.columns = {{"lighting", "lighting", "", ColumnKind::text},
                {"speed_law", "law", "", ColumnKind::text},
                {"beta_per_m", "beta", "1/m", ColumnKind::number},
                {"gain_share", "relative gain [95 % percentile]", "", ColumnKind::estimate},
                {"retained", "retained", "", ColumnKind::estimate},
                {"on_front", "front", "", ColumnKind::text}};
  h3.add_row({std::string("all"),
              std::string("squash"),
              Number{20.0},
              Estimate{0.2, 0.1, 0.3},
              Estimate{0.9, 0.8, 0.95},
              std::string("yes")});
  const std::string gain = pareto_figure(h3).value().caption;
  EXPECT_NE(gain.find("rate of advance (95 % percentile intervals)"), std::string::npos) << gain;
  EXPECT_EQ(gain.find("BCa"), std::string::npos);
  h3.columns[3].heading = "relative gain";
  EXPECT_NE(pareto_figure(h3).value().caption.find("(intervals)"), std::string::npos);
}

TEST(SetFigures, AreEmptyWithoutData) {
  const Table none;
  EXPECT_FALSE(roc_figure(none));
  EXPECT_FALSE(incidence_figure(none, ""));
  EXPECT_FALSE(calibration_figure(none));
  EXPECT_FALSE(forest_figure(none, none));
  EXPECT_FALSE(equivalence_figure(none, none));
  EXPECT_FALSE(pareto_figure(none));
  EXPECT_FALSE(cells_figure(none, "x", "x"));
  EXPECT_FALSE(gate_figure(none, none, none, none));
  EXPECT_FALSE(truth_figure(table::DataTable{}, std::nullopt));
}

table::DataTable table_of(const char* text) {
  table::CsvOptions csv;
  csv.file = "test.csv";
  return *table::read_data_table(table::Bytes::copy_of(text), {}, csv).table;
}

TEST(TruthFigure, TakesTheProvenIntervalAndLeavesOutWhatIsNotKnown) {
  const table::DataTable features = table_of(
      "trial_id,success,certificate_m,truth_lower_m,truth_upper_m\n"
      "t1,1,0.05,0.06,0.07\n"
      "t2,0,,0.01,0.02\n"
      "t3,1,0.1,,\n"
      "t4,,0.02,0.01,0.03\n");
  const Figure figure = *truth_figure(features, SyntheticLabel{1});
  std::size_t trials = 0;
  for (std::size_t row = 0; row < figure.data.rows.size(); ++row) {
    trials += text_at(figure.data, row, "part") == "trial" ? 1 : 0;
  }
  EXPECT_EQ(trials, 2U);
  EXPECT_EQ(drawn_classes(figure),
            (std::vector<std::string>{"success (dot: upper bound of T)",
                                      "outcome not known (dot: upper bound of T)"}));
  expect_same_data(figure);
}

/// T_t claims to be a lower bound of T, of which only an interval is known: it is refuted above the
/// interval alone.
TEST(TruthFigure, JudgesByTheUpperBound) {
  const table::DataTable features = table_of(
      "trial_id,success,certificate_m,truth_lower_m,truth_upper_m\n"
      "below,1,0.05,0.06,0.07\n"
      "within,1,0.065,0.06,0.07\n"
      "equal,0,0.07,0.06,0.07\n"
      "above,0,0.075,0.06,0.07\n");
  const Figure figure = *truth_figure(features, std::nullopt);
  std::vector<std::string> refuted;
  for (std::size_t row = 0; row < figure.data.rows.size(); ++row) {
    if (text_at(figure.data, row, "part") == "refuted") {
      refuted.push_back(text_at(figure.data, row, "trial_id"));
    }
  }
  EXPECT_EQ(refuted, std::vector<std::string>{"above"});
  for (const Layer& layer : figure.panels[0].layers) {
    if (layer.mark == Mark::point) {
      EXPECT_EQ(layer.y, "truth_upper_m") << "a dot below the diagonal is a refuted certificate";
    }
  }
  EXPECT_EQ(drawn_classes(figure).back(), "T_t above the upper bound: refuted");
}

TEST(TruthFigure, IsNotDrawnOfTrialsWithoutATruth) {
  EXPECT_FALSE(truth_figure(table_of("trial_id,success,certificate_m,truth_lower_m,truth_upper_m\n"
                                     "t1,1,0.05,,\n"),
                            std::nullopt));
}

Table incidence_table() {
  Table table;
  table.name = "h1_incidence_curve";
  for (const char* const name : {"panel", "strata", "state"}) {
    table.columns.push_back({name, "", "", ColumnKind::text});
  }
  for (const char* const name : {"time", "n.risk", "estimate", "conf.low", "conf.high"}) {
    table.columns.push_back({name, "", "", ColumnKind::number});
  }
  for (const char* const group : {"Q1", "Q2"}) {
    for (int i = 1; i <= 4; ++i) {
      table.add_row({std::string("paper"),
                     std::string(group),
                     std::string("egress"),
                     Number{10.0 * i},
                     Number{5.0 - i},
                     Number{0.2 * i},
                     Number{0.2 * i - 0.1},
                     Number{0.2 * i + 0.1}});
    }
  }
  return table;
}

TEST(IncidenceFigure, HasEachCurveAndEachBandInOnePiece) {
  const Figure figure = *incidence_figure(incidence_table(), "m3");
  EXPECT_EQ(figure.title, "Reaching the goal, by quartile of m3");
  std::vector<std::string> pieces;
  for (std::size_t row = 0; row < figure.data.rows.size(); ++row) {
    const std::string piece =
        text_at(figure.data, row, "part") + " " + text_at(figure.data, row, "quartile");
    if (pieces.empty() || pieces.back() != piece) {
      pieces.push_back(piece);
    }
  }
  EXPECT_EQ(std::count(pieces.begin(), pieces.end(), "curve Q1"), 1);
  EXPECT_EQ(std::count(pieces.begin(), pieces.end(), "band Q2"), 1);
  expect_same_data(figure);
}

TEST(Figure, RefusesALineTornByRowsOfAnother) {
  Figure torn = small_figure();
  torn.data.rows.clear();
  for (const char* const who : {"a", "b", "a", "b"}) {
    add_figure_row(torn.data, "curve", {who}, {0.1, 0.2});
  }
  EXPECT_THROW(check(torn), std::invalid_argument);
  EXPECT_NO_THROW(check(*finished(torn)));
}

TEST(FinishedFigure, NamesOnlyWhatIsDrawnAndDrawsNothingFromNothing) {
  Figure figure = small_figure();
  figure.key.classes = {"a", "b", "c"};
  const std::string script = gnuplot_script(*finished(figure));
  EXPECT_EQ(script.find("title 'c'"), std::string::npos) << "a legend of what is not there";
  EXPECT_EQ(vega_lite(*finished(figure))["layer"][0]["encoding"]["color"]["legend"]["values"],
            (std::vector<std::string>{"a", "b"}));
  Figure alone = small_figure();
  alone.panels[0].layers[0].guide = true;
  EXPECT_FALSE(finished(alone)) << "guides are no data";
  for (auto& row : figure.data.rows) {
    row.back() = TableCell{};
  }
  EXPECT_FALSE(finished(figure));
}

TEST(Figure, DrawsGuidesDashed) {
  Figure figure = small_figure();
  Layer ideal = guide("curve", "x_m", "y_m");
  figure.panels[0].layers.push_back(ideal);
  EXPECT_NE(gnuplot_script(figure).find("dt (7,8)"), std::string::npos);
  EXPECT_EQ(vega_lite(figure)["layer"][1]["mark"]["strokeDash"], (std::vector<int>{5, 4}));
}

TEST(RoundTicks, AreEvenAndAsLongAsTheirLabels) {
  EXPECT_EQ(round_ticks(0.83, 1.01, 4), (std::vector<double>{0.85, 0.9, 0.95, 1.0}));
  EXPECT_EQ(tick_decimals({0.85, 0.9, 0.95, 1.0}), 2);
  EXPECT_EQ(round_ticks(-0.2, 0.65, 5), (std::vector<double>{-0.2, 0.0, 0.2, 0.4, 0.6}));
  EXPECT_EQ(tick_decimals({0.0, 50.0, 100.0}), 0);
  EXPECT_EQ(round_ticks(0.0, 1e6, 5).back(), 1e6);
  EXPECT_TRUE(round_ticks(1.0, 1.0, 5).empty());
  Axis share = share_axis("share");
  Figure figure = small_figure();
  figure.panels[0].y = share;
  EXPECT_NE(gnuplot_script(figure).find("set ytics ('0.0' 0, '0.2' 0.2"), std::string::npos);
  EXPECT_EQ(vega_lite(figure)["layer"][0]["encoding"]["y"]["axis"]["format"], ".1f");
}

TEST(RatioTicks, AreAFewForAnySpan) {
  const double spans[][2] = {
      {0.95, 1.02}, {0.9, 1.9}, {0.9, 2.5}, {0.7, 19}, {0.01, 40}, {1e-4, 1e5}};
  for (const auto& span : spans) {
    const std::vector<double> ticks = ratio_ticks(span[0], span[1]);
    EXPECT_GE(ticks.size(), 2U) << span[0];
    EXPECT_LE(ticks.size(), 12U) << span[0];
  }
}

TrialPicture small_trial() {
  TrialPicture trial;
  trial.trial_id = "t1";
  trial.series = table_of(
      "time_s,x_m,y_m,yaw_rad,left_m,right_m,margin_m,edge_margin_m,corridor_value_m,certificate_m,"
      "speed_law_mps,flags,issued\n"
      "0,0,0,0,0.5,,0.2,0.2,0.2,,0.1,,0\n"
      "0.5,0.1,0,0,0.5,0.4,0.1,0.1,0.1,,0.1,,0\n"
      "1,0.2,0,0,0.5,0.4,0.1,0.1,0.1,0.1,0.1,break,1\n");
  trial.edges = table_of("edge,a_x_m,a_y_m,b_x_m,b_y_m,margin_m\n0,0,0,0.2,0,0.1\n");
  trial.bottleneck_x_m = 0.1;
  trial.bottleneck_y_m = 0.0;
  return trial;
}

std::map<std::string, std::size_t> parts_of(const Figure& figure) {
  std::map<std::string, std::size_t> parts;
  for (std::size_t row = 0; row < figure.data.rows.size(); ++row) {
    ++parts[text_at(figure.data, row, "part")];
  }
  return parts;
}

TEST(TrialMap, HasThePathTheGraphTheBottleneckAndThePlaceOfIssuance) {
  const Figure figure = *trial_map_figure(small_trial());
  auto parts = parts_of(figure);
  EXPECT_EQ(parts["felt"], 5U);
  EXPECT_EQ(parts["path"], 4U) << "three ticks and a break";
  EXPECT_EQ(parts["edge"], 1U);
  EXPECT_EQ(parts["bottleneck"], 1U);
  EXPECT_EQ(parts["issued"], 1U);
  EXPECT_TRUE(figure.panels[0].equal_scale);
  expect_same_data(figure);
}

TEST(TrialMap, DrawsTheKnownWorldInPlaceOfWhatWasFelt) {
  TrialPicture trial = small_trial();
  World world;
  world.obstacles = {Polygon{{{0, 1}, {1, 1}, {1, 2}}}, Disc{{0, -1}, 0.2}};
  world.start = Disc{{0, 0}, 0.1};
  trial.world = world;
  const Figure figure = *trial_map_figure(trial);
  auto parts = parts_of(figure);
  EXPECT_EQ(parts["felt"], 0U);
  EXPECT_EQ(parts["wall"], 3U + 36U);
  EXPECT_NE(gnuplot_script(figure).find("set object 2 polygon"), std::string::npos);
  expect_same_data(figure);
}

TEST(TrialSeries, MeasuresSpeedOverTheLastSecondAndLeavesTheBeginningOut) {
  const Figure figure = *trial_series_figure(small_trial());
  std::vector<double> speeds;
  for (std::size_t row = 0; row < figure.data.rows.size(); ++row) {
    if (text_at(figure.data, row, "quantity") == "measured speed") {
      speeds.push_back(number_at(figure.data, row, "value"));
    }
  }
  ASSERT_EQ(speeds.size(), 3U);
  EXPECT_TRUE(std::isnan(speeds[0]));
  EXPECT_DOUBLE_EQ(speeds[1], 0.2);
  EXPECT_DOUBLE_EQ(speeds[2], 0.2);
  expect_same_data(figure);
}

TEST(TrialFigures, CountTimeFromTheFirstTick) {
  TrialPicture trial = small_trial();
  const Figure from_zero = *trial_series_figure(trial);
  for (double& time : trial.series.columns[0].numbers) {
    time += 1.7e9;  // Since 1970: a span of a second would be a vertical line.
  }
  const Figure since_1970 = *trial_series_figure(trial);
  EXPECT_EQ(figure_csv(since_1970), figure_csv(from_zero));
  EXPECT_EQ(vega_lite(since_1970), vega_lite(from_zero));
  EXPECT_EQ(since_1970.panels[0].x.low, 0.0);
  EXPECT_EQ(since_1970.panels[0].x.high, 1.0);
  const Figure map = *trial_map_figure(trial);
  for (std::size_t row = 0; row < map.data.rows.size(); ++row) {
    EXPECT_FALSE(number_at(map.data, row, "time_s") > 1.0);
  }
}

TEST(TrialFigures, AreNotDrawnWithoutAValue) {
  TrialPicture trial;
  trial.trial_id = "t1";
  trial.series = table_of("time_s,x_m,y_m,margin_m,flags,issued\n0,,,,,0\n1,,,,,0\n");
  EXPECT_FALSE(trial_series_figure(trial));
  EXPECT_FALSE(trial_map_figure(trial));
}

}  // namespace
}  // namespace tcert
