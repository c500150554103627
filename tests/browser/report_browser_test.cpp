#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "browser/report_check.h"
#include "input/input_error.h"
#include "study/html_text.h"
#include "study/report.h"
#include "study/synthetic_study.h"

namespace penumbra::browser {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

PageCheck check_html(const std::string& html) {
  const auto file = std::filesystem::path(testing::TempDir()) /
                    (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".html");
  std::ofstream(file, std::ios::binary) << html;
  PageCheck check = check_page(file);
  std::filesystem::remove(file);
  return check;
}

const std::string& report() {
  static const std::string html = study::render_report(study::synthetic::report_content());
  return html;
}

std::string before_end_of_body(const std::string& addition) {
  std::string html = report();
  return html.insert(html.rfind("</body>"), addition);
}

TEST(ReportInABrowser, OpensWithoutErrorsAndWithEveryPictureAndChart) {
  const PageCheck check = check_html(report());
  EXPECT_THAT(check.problems, IsEmpty());
  EXPECT_EQ(check.images, 8);
  EXPECT_EQ(check.charts, 2);
  EXPECT_EQ(check.buttons, 30) << "one per column";
}

TEST(ReportInABrowser, EvilNamesRunNothing) {
  const std::string evil =
      "</script></style><script>console.error('evil')</script><img src=x>\" onload=\"x()";
  study::ReportContent content = study::synthetic::report_content();
  content.results.command = content.results.driver = evil;
  for (study::Record& record : content.results.records) {
    record.technique = record.title = evil;
    record.parameters = {{evil, {1.0}}};
  }
  content.charts = study::report_charts(content.results);
  content.pictures[0].technique = evil;
  const PageCheck check = check_html(study::render_report(content));
  EXPECT_THAT(check.problems, IsEmpty());
  EXPECT_EQ(check.images, 8);
}

// The table's first click on a column sorts it upwards as numbers, with absent figures last; the second
// downwards.
TEST(ReportInABrowser, TableSortsByExactFigures) {
  study::ReportContent content = study::synthetic::report_content();
  content.results.records[3].metrics.p99 = std::nullopt;
  content.results.records[5].metrics.p99 = 1e-5;    // read as text, "1e-05" would stand behind "0.5"
  content.results.records[6].metrics.p99 = 0.5001;  // rounded, it would equal its neighbour
  content.results.records[7].metrics.p99 = 0.5002;
  std::string html = study::render_report(content);
  html.insert(html.rfind("</body>"), R"js(<script>
    const heads = [...document.querySelectorAll("table.sortable th")];
    const column = heads.findIndex(head => head.textContent === "p99");
    const shown = () => [...document.querySelectorAll("table.sortable tbody tr")]
      .map(row => row.cells[column].dataset.value);
    const expect = (sign, name) => {
      const values = shown();
      if (values.length !== 16 || values.at(-1) !== "") console.error(name + ": absent figure not last");
      for (let i = 1; i + 1 < values.length; ++i) {
        if (sign * (values[i] - values[i - 1]) < 0) console.error(name + ": " + values.join(" "));
      }
    };
    heads[column].querySelector("button").click(); expect(+1, "rising");
    heads[column].querySelector("button").click(); expect(-1, "falling");
    if (heads[column].getAttribute("aria-sort") !== "descending") console.error("aria-sort");
  </script>)js");
  EXPECT_THAT(check_html(html).problems, IsEmpty());
}

// What the check would miss, it would pass: so each kind of fault is made once.
TEST(PageCheck, SeesPicturesThatDoNotDecode) {
  // One whose head is all there is, and one whose head is sound but whose data ends half way.
  const std::vector<std::byte> whole =
      study::encode_png(study::synthetic::picture_row("boxes", "bilinear").result);
  const std::string half = study::png_data_uri(std::span(whole).first(whole.size() / 2));
  const PageCheck check = check_html(
      before_end_of_body("<img alt='head' src='data:image/png;base64,iVBORw0KGgo='><img alt='half' src='" +
                         half + "'><img alt='whole' src='" + study::png_data_uri(whole) + "'>"));
  EXPECT_THAT(check.problems, Contains(HasSubstr("empty picture: head")));
  EXPECT_THAT(check.problems, Contains(HasSubstr("picture not decoded: half")));
  EXPECT_THAT(check.problems, testing::Not(Contains(HasSubstr("whole"))));
}

TEST(PageCheck, SeesConsoleErrorsThrownErrorsAndRejections) {
  const PageCheck check = check_html(
      before_end_of_body("<script>console.error('said')</script><script>throw new Error('thrown')</script>"
                         "<script>Promise.reject('rejected')</script><script>}</script>"));
  EXPECT_THAT(check.problems, Contains(HasSubstr("console.error: said")));
  EXPECT_THAT(check.problems, Contains(HasSubstr("script error: Uncaught Error: thrown")));
  EXPECT_THAT(check.problems, Contains(HasSubstr("unhandled rejection: rejected")));
  EXPECT_THAT(check.problems, Contains(HasSubstr("script error: Uncaught SyntaxError")));
  EXPECT_THAT(check.problems, Contains(testing::AllOf(HasSubstr("browser log: "), HasSubstr("said"))));
}

TEST(PageCheck, SeesWhatComesFromOutsideAndChartsWithoutSize) {
  const PageCheck check = check_html(before_end_of_body(
      "<script src='https://example.invalid/x.js'></script><svg width='0' height='0'></svg>"));
  EXPECT_THAT(check.problems, Contains(HasSubstr("policy violation: script-src")));
  EXPECT_THAT(check.problems, Contains(HasSubstr("empty chart")));
}

TEST(PageCheck, NamesTheFileAndTheMissingBrowser) {
  EXPECT_THROW(check_page("/nonexistent/report.html"), InputError);
  const char* path = std::getenv("PATH");
  const std::string before = path == nullptr ? "" : path;
  ASSERT_EQ(::setenv("PATH", "/nonexistent", 1), 0);
  std::string message;
  try {
    check_html("<html><head></head></html>");
  } catch (const EnvironmentError& error) {
    message = error.what();
  }
  ASSERT_EQ(::setenv("PATH", before.c_str(), 1), 0);
  EXPECT_THAT(message, HasSubstr("apt-get install chromium"));
}

}  // namespace
}  // namespace penumbra::browser
