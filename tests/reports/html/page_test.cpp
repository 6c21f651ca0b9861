#include "reports/html/page.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "reports/html/packed.hpp"
#include "reports/html/report_json.hpp"
#include "tests/reports/html/unpacked.hpp"

namespace tcert {
namespace {

constexpr const char* kTemplate =
    "<meta content=\"{{policy}}\"><title>{{title}}</title><style>{{style}}</style>"
    "<script id=report>{{report}}</script><i>{{trials}}</i><i>{{series}}</i><i>{{worlds}}</i>"
    "<i>{{frames}}</i><i>{{licences}}</i><script>{{script}}</script>";

PageAssets assets() { return {kTemplate, "p{}", "run()", {}, "MIT"}; }

TEST(Packed, Base64OfTheStandard) {  // RFC 4648, section 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Packed, UnpacksToTheSameText) {
  for (const std::string& text :
       {std::string(), std::string("x"), std::string(5000, 'a') + "\n<\xff"}) {
    EXPECT_EQ(unpacked(packed(text)), text);
    EXPECT_EQ(packed(text).find_first_of("<>&\n "), std::string::npos);
  }
}

TEST(Page, AllowsItsOwnScriptAndStyleByDigestAndNothingElse) {
  const std::string html = page(assets(), {});
  // printf 'run()' | openssl dgst -sha256 -binary | base64, and the same of 'p{}'.
  EXPECT_NE(html.find("default-src 'none'; "
                      "script-src 'sha256-AvyuiL0SD1mVY3NNxR+V2uo+lhk6RMFrytWmRt6CrJQ='; "
                      "style-src 'sha256-gG2yISYereRMiG2lMXrbiUgi0Ubw9p7QCeWcroOvy9Y='; "
                      "img-src data:; base-uri 'none'; form-action 'none'"),
            std::string::npos)
      << html;
}

TEST(Page, DataCannotEndTheirBlock) {
  PageData data;
  data.title = "</title><script>x()</script>";
  data.report = nlohmann::json("</script><script>x()").dump();
  const std::string html = page(assets(), data);
  EXPECT_EQ(html.find("x()</script>"), std::string::npos);
  EXPECT_NE(html.find("<title>&lt;/title&gt;&lt;script&gt;x()"), std::string::npos);
  const std::string block = "id=report>";
  const auto from = html.find(block) + block.size();
  const std::string json = html.substr(from, html.find("</script>", from) - from);
  EXPECT_EQ(nlohmann::json::parse(json), "</script><script>x()");
}

TEST(Page, DataThatLookLikeAPlaceAreData) {
  PageData data;
  data.report = "\"{{script}} {{series}}\"";
  data.series = {"a", "b"};
  const std::string html = page(assets(), data);
  EXPECT_NE(html.find("\"{{script}} {{series}}\""), std::string::npos);
  EXPECT_NE(html.find("<i>a\nb\n</i>"), std::string::npos);
}

TEST(Page, RefusesAScriptThatWouldEndEarly) {
  PageAssets bad = assets();
  bad.script = "s = '</Script>'";
  EXPECT_THROW(static_cast<void>(page(bad, {})), std::runtime_error);
  bad = assets();
  bad.html = "no places";
  EXPECT_THROW(static_cast<void>(page(bad, {})), std::runtime_error);
}

TEST(ReportJson, PrintsCellsAndKeepsTheirCsv) {
  Table table;
  table.name = "t";
  table.title = "A table";
  table.columns = {{"name", "name", "", ColumnKind::text},
                   {"x", "x", "m", ColumnKind::estimate, 2}};
  table.add_row({std::string("a"), Estimate{0.123456, 0.1, 0.2}});
  table.add_row({std::string("b"), std::monostate()});
  PageContents contents;
  contents.tables = {{"h1", true, table}};
  contents.synthetic = SyntheticLabel{3};
  const auto json = nlohmann::json::parse(report_json(contents));
  EXPECT_EQ(json["tables"][0]["rows"][0][1], "0.12 [0.10, 0.20]");
  EXPECT_EQ(json["tables"][0]["rows"][1][1], "NA");
  EXPECT_EQ(json["tables"][0]["csv"], render(table, TableFormat::csv));
  EXPECT_EQ(json["tables"][0]["n"], nullptr);
  EXPECT_EQ(json["synthetic"], to_string(SyntheticLabel{3}));
}

TEST(ReportJson, ListsEveryParameterOnceForAllThatShareThem) {
  PageContents contents;
  Result one;
  one.name = "certificates";
  one.manifest.command = "certify";
  one.manifest.parameters = {{"tick_s", "0.1"}, {"body_width_m", ""}};
  Result two = one;
  two.name = "replays";
  Result other = one;
  other.name = "narrow";
  other.manifest.parameters = {{"tick_s", "0.2"}};
  contents.results = {one, two, other};
  const auto settings = nlohmann::json::parse(report_json(contents))["methods"]["settings"];
  ASSERT_EQ(settings.size(), 2U);
  EXPECT_EQ(settings[0]["title"], "Every parameter, as it took effect: certificates, replays");
  EXPECT_EQ(settings[0]["rows"][0][0], "tick_s");
  EXPECT_EQ(settings[0]["rows"][0][1], "0.1");
  EXPECT_EQ(settings[0]["rows"][0][2], "s");
  EXPECT_EQ(settings[0]["rows"][1][1], "not set");
  EXPECT_EQ(settings[1]["rows"][0][1], "0.2");
}

}  // namespace
}  // namespace tcert
