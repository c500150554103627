#include "study/report.h"

#include <gmock/gmock.h>

#include <regex>

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
       {"made-up processor, 2 cores", "made-up device", "made-up driver 1.2", "Penumbra 0.1.0",
        "<code>penumbra measure --seed 1</code>", "milliseconds are CPU time and rank nothing"}) {
    EXPECT_THAT(html, HasSubstr(text));
  }
}

TEST_F(Report, ShowsTheHeadlinesChartsPicturesAndEveryRecord) {
  const std::string html = render_report(*content_);
  for (const Headline& headline : headlines(content_->results)) {
    EXPECT_THAT(html, HasSubstr("<p class=\"value\">" + headline.value + "</p>"));
  }
  EXPECT_EQ(count(html, "<svg"), 2);
  EXPECT_EQ(count(html, "<img "), 8) << "four pictures and the legend of each";
  EXPECT_EQ(count(html, "<td class=\"name\" data-value=\"pcss-24-16\""), 4);
  // The exact figure to sort by, the rounded one to read: p99 of the first record is 2 (0.25 + 0.0053).
  EXPECT_THAT(html, HasSubstr("<td data-value=\"0.5106\">0.511</td>"));
  EXPECT_THAT(html, HasSubstr("<td>1024</td><td>0.0040</td>")) << "the noise floor of each reference";
}

TEST_F(Report, ExplainsEveryFigureAndReference) {
  const std::string html = render_report(*content_);
  for (const char* term : {"T1: ray tracing", "T2: the same map, exhaustively",
                           "T3: the technique, unlimited", "Error split", "RMSE penumbra", "RMSE all", "Bias",
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
  const std::string evil = "\"><script>alert(1)</script><img src=x onerror='alert(2)'>&amp;";
  ReportContent content = *content_;
  content.results.command = content.results.hardware = content.results.device = content.results.driver = evil;
  content.results.library_version = evil;
  for (Record& record : content.results.records) {
    record.scene = record.technique = record.title = record.map_format = record.reference.kind = evil;
    record.parameters = {{evil, {1.0}}};
    record.metrics.invalid = 1;
  }
  content.charts[0].caption = evil;
  content.pictures[0].scene = content.pictures[0].technique = evil;
  const std::string html = render_report(content);
  EXPECT_EQ(count(html, "<script"), 1) << "only the report's own";
  EXPECT_EQ(count(html, "<img "), 8);
  EXPECT_THAT(html, Not(HasSubstr("onerror='")));
  EXPECT_THAT(html, HasSubstr(escape_html(evil)));
}

TEST_F(Report, AFindingIsToldAboveEverything) {
  EXPECT_THAT(render_report(*content_), Not(HasSubstr("class=\"finding\"")));
  ReportContent content = *content_;
  content.results.records[5].metrics.invalid = 3;
  EXPECT_THAT(render_report(content), HasSubstr("3 results are no visibility"));
}

TEST_F(Report, AnAbsentFigureIsADashThatSortsLast) {
  ReportContent content = *content_;
  content.results.records.resize(1);
  content.results.records[0].metrics.rmse_penumbra = std::nullopt;
  EXPECT_THAT(render_report(content), HasSubstr("<td data-value=\"\">–</td>"));
}

TEST(EmptyReport, IsStillAPage) {
  const std::string html = render_report({});
  EXPECT_THAT(html, HasSubstr("</html>"));
  EXPECT_THAT(html, Not(HasSubstr("<h2>Pictures</h2>")));
  EXPECT_TRUE(report_charts({}).empty());
}

}  // namespace
}  // namespace penumbra::study
