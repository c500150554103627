#include "study/report.h"

#include <gmock/gmock.h>

#include <regex>
#include <span>

#include "study/colour_map.h"
#include "study/html_text.h"
#include "study/summary.h"
#include "study/synthetic_study.h"

namespace penumbra::study {
namespace {

using testing::HasSubstr;
using testing::Not;

int count(const std::string& text, const std::string& what) {
  int found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

class Report : public testing::Test {
 protected:
  static void SetUpTestSuite() { content_ = new ReportContent(synthetic::report_content()); }
  static void TearDownTestSuite() { delete content_; }

  static ReportContent* content_;
};

ReportContent* Report::content_ = nullptr;

TEST_F(Report, SaysOnWhatAndHowItWasMeasured) {
  const std::string html = render_report(*content_);
  for (const char* text :
       {"made-up processor, 2 cores", "made-up device", "made-up driver 1.2",
        "<dt>Compiler</dt><dd>glslang</dd>", "Penumbra 0.1.0",
        "commit <code>0123456789abcdef0123456789abcdef01234567</code>", "com.example.shadows 17.0.3",
        "<span>penumbra</span> <span>measure</span> <span>--seed</span> <span>1</span></code>",
        "milliseconds are CPU time and say little about speed on a GPU"}) {
    EXPECT_THAT(html, HasSubstr(text));
  }
}

TEST_F(Report, NamesTheCompilerOfTheShaders) {
  ReportContent content = *content_;
  content.results.front_end = "FXC <1>";
  EXPECT_THAT(render_report(content), HasSubstr("<dt>Compiler</dt><dd>FXC &lt;1&gt;</dd>"));
}

TEST_F(Report, ShowsTheHeadlinesChartsAndEveryRecord) {
  const std::string html = render_report(*content_);
  for (const Headline& headline : headlines(content_->results)) {
    EXPECT_THAT(html, HasSubstr("<p class=\"value\">" + headline.value + "</p>"));
  }
  EXPECT_EQ(count(html, "<svg"), 2 * 2) << "two charts, two lights";
  EXPECT_EQ(count(html, R"({"technique":"pcss-24-16")"), 4 + 2) << "two scenes and their mean, two lights";
  // The exact figure is there to sort by, the rounded one to read: 0.25 + 0.0053 of the first record.
  EXPECT_THAT(html, HasSubstr(R"([0.2553,"0.255 \u00b1 0.004"])"));
  EXPECT_THAT(html, HasSubstr(R"(["99th percentile","0.511"])"));
  EXPECT_THAT(html, HasSubstr(R"(["bias","\u22120.0255"])"));
  EXPECT_THAT(html, HasSubstr("<td>1024</td><td>0.0040</td>")) << "the noise floor of each reference";
}

TEST_F(Report, OneRowForEachTechniqueThatWasMeasured) {
  EXPECT_THAT(render_report(*content_), Not(HasSubstr("One row for each technique")));
  ReportContent content = *content_;
  content.facts["tent-5x5"] = {"few <fetches>", "wide discs", {}};
  content.facts["unmeasured"].use_when = "of nothing measured";
  const std::string html = render_report(content);
  EXPECT_EQ(count(html, "<td class=\"name\">few &lt;fetches&gt;</td><td class=\"name\">wide discs</td>"), 1);
  EXPECT_THAT(html, HasSubstr("<a href=\"#techniques\">One row for each technique</a>"));
  EXPECT_THAT(html, Not(HasSubstr("of nothing measured")));
}

TEST_F(Report, EachReferenceStandsOnce) {
  // There are two scenes at one light with two techniques each: one reference and its receivers for a scene,
  // result and fetches of each technique.
  ASSERT_EQ(content_->pictures.size(), 4U);
  EXPECT_EQ(count(render_report(*content_), "id=\"png-"), 2 * 2 + 4 * 2);
}

TEST_F(Report, PicturesComeFromTheColourTablesOfThePictureFiles) {
  const Picture strip = ramp_strip(error_colour, -1.0, 1.0);
  EXPECT_THAT(render_report(*content_), HasSubstr(base64(std::as_bytes(std::span(strip.samples)))));
}

TEST_F(Report, WithoutPicturesItSaysHowToGetThem) {
  ReportContent content = *content_;
  content.pictures.clear();
  const std::string html = render_report(content);
  EXPECT_THAT(html, HasSubstr("<span>1</span> <span>--output</span> <span>report</span></code>"));
  EXPECT_THAT(html, Not(HasSubstr("<canvas")));
  EXPECT_THAT(html, Not(HasSubstr("\"pictures\":")));
}

TEST_F(Report, AColumnWithoutAnyFigureIsLeftOut) {
  EXPECT_THAT(render_report(*content_), HasSubstr(R"("title":"False shadow")"));
  ReportContent content = *content_;
  for (Record& record : content.results.records) record.metrics.false_shadow_rate = std::nullopt;
  EXPECT_THAT(render_report(content), Not(HasSubstr(R"("title":"False shadow")")));
}

TEST_F(Report, ShowsTheFiguresOfEachCascade) {
  EXPECT_THAT(render_report(*content_), Not(HasSubstr("By the cascade")));
  ReportContent content = *content_;
  CascadeRecord near;
  near.penumbra_pixels = 1234;
  near.rmse_penumbra = 0.0625;
  near.leak_rate = 0.0125;
  near.intervals.rmse_penumbra = Interval{0.051, 0.074, 0.006};
  CascadeRecord far;
  far.technique = "tent-5";
  far.parameters = {{"taps", {8.0}}};
  content.results.records[0].per_cascade = {near, {}, far, far};
  EXPECT_THAT(render_report(content),
              HasSubstr(R"(["cascade 0","1234 penumbra pixels, RMSE 0.0625 (0.051 to 0.074), leaks 1.25 %"],)"
                        R"(["cascade 1","0 penumbra pixels"],)"
                        R"(["cascade 2","0 penumbra pixels, by tent-5, taps 8"])"));
}

TEST_F(Report, ExplainsEveryFigureAndReference) {
  const std::string html = render_report(*content_);
  for (const char* term :
       {"T1: ray tracing", "T2: all the information in the shadow map",
        "T3: the technique without a sample limit", "Error split", "RMSE penumbra", "RMSE all", "Bias",
        "Variance", "p99", "Max", "Leak", "False shadow", "Fetches", "Time", "Invalid"}) {
    EXPECT_THAT(html, HasSubstr(std::string("<dt>") + term + "</dt>"));
  }
}

TEST_F(Report, LoadsNothingFromAnywhere) {
  const std::string html = render_report(*content_);
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
  const std::regex address("(src|href|srcset|action|data|poster)\\s*=\\s*[\"']?([a-z]+:[^\"' >]{0,30}|/)");
  for (auto match = std::sregex_iterator(html.begin(), html.end(), address); match != std::sregex_iterator();
       ++match) {
    EXPECT_THAT((*match)[2].str(), testing::StartsWith("data:image/png;base64,"));
  }
  EXPECT_THAT(html, Not(HasSubstr("@import")));
  EXPECT_THAT(html, Not(HasSubstr("url(http")));
}

TEST_F(Report, TheSameContentIsTheSameBytes) {
  EXPECT_EQ(render_report(*content_), render_report(*content_));
}

TEST_F(Report, EvilNamesStayText) {
  const std::string evil = "\"></script><script>alert(1)</script><img src=x onerror='alert(2)'>&amp;\n";
  const int scripts = count(render_report(*content_), "<script");
  ReportContent content = *content_;
  content.results.command = content.results.hardware = content.results.device = content.results.driver = evil;
  content.results.library_version = evil;
  for (Record& record : content.results.records) {
    record.technique += evil;
    record.scene += evil;
    record.title = record.map_format = record.reference.kind = evil;
    record.parameters = {{evil, {1.0}}};
    record.metrics.invalid = 1;
  }
  content.charts = report_charts(content.results);
  content.charts[0].caption = evil;
  for (PictureRow& row : content.pictures) {
    row.scene += evil;
    row.technique += evil;
  }
  const std::string html = render_report(content);
  EXPECT_EQ(count(html, "<script"), scripts) << "only the report's own";
  EXPECT_EQ(count(html, "<img"), 0);
  EXPECT_THAT(html, HasSubstr(escape_html(evil)));
}

TEST_F(Report, AFindingIsToldAboveEverything) {
  EXPECT_THAT(render_report(*content_), Not(HasSubstr("class=\"finding\"")));
  ReportContent content = *content_;
  content.results.records[5].metrics.invalid = 3;
  EXPECT_THAT(render_report(content), HasSubstr("3 results are NaN, infinite or outside [0, 1]"));
}

TEST_F(Report, AnAbsentFigureIsADashThatSortsLast) {
  ReportContent content = *content_;
  content.results.records[1].metrics.rmse_penumbra = std::nullopt;
  EXPECT_THAT(render_report(content), HasSubstr(R"([null,"\u2013"])"));
}

TEST(EmptyReport, IsStillAPage) {
  const std::string html = render_report({});
  EXPECT_THAT(html, HasSubstr("</html>"));
  EXPECT_THAT(html, Not(HasSubstr("<h2>Pictures</h2>")));
  EXPECT_THAT(html, Not(HasSubstr("<table")));
  EXPECT_TRUE(report_charts({}).empty());
}

}  // namespace
}  // namespace penumbra::study
