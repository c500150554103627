#include "study/chart.h"

#include <gmock/gmock.h>

#include <cmath>

#include "processor_time.h"
#include "study/report_charts.h"
#include "study/synthetic_study.h"
#include "study/xml_outline.h"

namespace penumbra::study {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

int count(const std::string& text, const std::string& what) {
  int found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

Chart small_chart() {
  return {"small",
          "A title",
          "cost",
          "error",
          {{"one light", {{"cheap", 1.0, 0.3}, {"good", 90.0, 0.1}}, {0, 1}}}};
}

TEST(XmlOutline, SeesWhatDoesNotParse) {
  EXPECT_EQ(xml_fault("<?xml?><a b='c'><d/>text &amp; more</a>"), "");
  EXPECT_NE(xml_fault("<a><b></a></b>"), "");
  EXPECT_NE(xml_fault("<a>"), "");
  EXPECT_NE(xml_fault("<a>x < y</a>"), "");
  EXPECT_NE(xml_fault("<a>x & y</a>"), "");
  EXPECT_NE(xml_fault("<a>x ]]> y</a>"), "");
}

TEST(Chart, IsAnSvgThatParsesAndHoldsEveryLabel) {
  const std::string svg = render_svg(small_chart());
  EXPECT_EQ(xml_fault(svg), "");
  for (const char* text : {">one light<", ">cost<", ">error<"}) EXPECT_EQ(count(svg, text), 1) << text;
  for (const char* text : {">A title<", ">cheap<", ">good<"})
    EXPECT_EQ(count(svg, text), 2) << text << ": also <title>";
}

TEST(Chart, AFrontMayHoldPointsThatHaveNoPlace) {
  Chart chart = small_chart();
  const std::string without = render_svg(chart);
  chart.panels[0].points.push_back({"free", 0.0, 0.05});
  chart.panels[0].points.push_back({"broken", 3.0, std::nan("")});
  chart.panels[0].front = {2, 0, 3, 1};
  EXPECT_EQ(render_svg(chart), without);
}

TEST(Chart, EvilLabelsStayText) {
  Chart chart = small_chart();
  chart.title = "<script>alert('&')</script>";
  chart.panels[0].title = "`touch evil` $(x) %s \\n {/Symbol a}_b^c @d";
  chart.panels[0].points[0].label = "it's\n\"quoted\"'; set output 'evil'; #";
  const std::string svg = render_svg(chart);
  EXPECT_EQ(xml_fault(svg), "");
  EXPECT_THAT(svg, Not(HasSubstr("<script")));
  EXPECT_THAT(svg, HasSubstr("{/Symbol a}_b^c @d"));
  EXPECT_THAT(svg, HasSubstr("; set output "));
}

// XML has no such text outside of a CDATA section.
TEST(Chart, LabelsMayEndCdataSections) {
  Chart chart = small_chart();
  for (std::string* text : {&chart.title, &chart.x_label, &chart.y_label, &chart.panels[0].title,
                            &chart.panels[0].points[0].label})
    *text = "a ]]> b";
  const std::string svg = render_svg(chart);
  EXPECT_EQ(xml_fault(svg), "");
  EXPECT_EQ(count(svg, "a ]]&gt; b"), 7) << "the titles and the point's label are also <title>";
  for (const std::string& panel : render_panels(chart)) EXPECT_EQ(xml_fault(panel), "");
}

TEST(Chart, LeavesOutWhatHasNoPlace) {
  Chart chart = small_chart();
  chart.panels[0].points.push_back({"nowhere", std::nan(""), 0.1});
  chart.panels[0].points.push_back({"free", 0.0, 0.1});
  const std::string svg = render_svg(chart);
  EXPECT_THAT(svg, Not(HasSubstr("nowhere")));
  EXPECT_THAT(svg, Not(HasSubstr("free")));
  chart.panels[0].points.clear();
  chart.panels[0].front.clear();
  EXPECT_THROW(render_svg(chart), std::invalid_argument);
}

TEST(Chart, OnePointIsEnough) {
  Chart chart = small_chart();
  chart.panels[0] = {"one light", {{"alone", 5.0, 0.0}}, {0}};
  EXPECT_THAT(render_svg(chart), HasSubstr(">alone<"));
}

TEST(Chart, PointsStepsAndTicksLieOnTheAxes) {
  Chart chart = small_chart();
  chart.panels[0].points = {{"cheap", 1.0, 0.3}, {"dear", 100.0, 0.3}, {"good", 10.0, 0.1}};
  chart.panels[0].front = {0, 2};
  const std::string svg = render_svg(chart);
  // The axes go from 1 / 1.6 to 160 over the pixels 72 to 800, and from 0 to 0.345 over 324 to 70.
  EXPECT_THAT(svg, HasSubstr("<path class=\"step\" d=\"M133.7 103.1H436.0V250.4\"/>"));
  EXPECT_THAT(svg, HasSubstr("<g class=\"point\"><circle class=\"mark\" cx=\"738.3\" cy=\"103.1\" r=\"3\"/>"
                             "<title>dear</title>"));
  EXPECT_THAT(svg, HasSubstr("<text x=\"436.0\" y=\"342.0\" text-anchor=\"middle\">10</text>"));
  EXPECT_THAT(svg, HasSubstr("<text x=\"63.0\" y=\"254.9\" text-anchor=\"end\">0.1</text>"));
}

TEST(Chart, ARangeBelowTwoPowersOfTenHasTicksBetweenThem) {
  Chart chart = small_chart();
  chart.panels[0].points = {{"one", 4.0, 0.0}, {"other", 30.0, 2000.0}};
  const std::string svg = render_svg(chart);
  for (const char* tick : {">5<", ">10<", ">20<", ">0<", ">500<", ">2e+03<"})
    EXPECT_THAT(svg, HasSubstr(tick));
}

TEST(PagePanels, HaveOneDrawingEachWhosePointsAreLinks) {
  const Chart chart = fetches_chart(synthetic::results());
  const std::vector<std::string> panels = render_panels(chart);
  ASSERT_EQ(panels.size(), 2U);
  for (const std::string& panel : panels) {
    EXPECT_EQ(xml_fault(panel), "");
    EXPECT_THAT(panel, Not(HasSubstr("<title>")));
    EXPECT_THAT(panel, Not(HasSubstr(">2° light<"))) << "the page writes the title";
    EXPECT_THAT(panel, Not(HasSubstr("#fcfcfb"))) << "the page has the colours";
    EXPECT_EQ(count(panel, "<a class=\"point front\" href=\"#figures\""), 4);
  }
  EXPECT_THAT(panels[1], HasSubstr("aria-label=\"2° light\""));
}

// Every place of a label is tried against what is there already, so of very many points only some are tried.
TEST(Chart, OfVeryManyPointsSomeHaveLabelsAndThoseOfTheFrontFirst) {
  Chart chart = small_chart();
  chart.panels = {{"one light", {}, {}}};
  for (std::size_t i = 0; i < 20'000; ++i) {
    const double share = static_cast<double>(i % 997) / 997.0;
    chart.panels[0].points.push_back(
        {"technique " + std::to_string(i), 10.0 + 100.0 * share, 0.5 - 0.4 * share});
  }
  chart.panels[0].front = {996};
  std::string svg;
  EXPECT_LT(processor_seconds([&] { svg = render_svg(chart); }), 20.0)
      << "what grows with the cube takes hours";
  EXPECT_EQ(count(svg, "<title>technique "), 20'000);
  EXPECT_EQ(count(svg, "class=\"front name\""), 1);
}

TEST(ParetoCharts, APointSaysItsFiguresAndHowManyScenesItIsAMeanOf) {
  const Chart chart = fetches_chart(synthetic::results());
  EXPECT_EQ(chart.panels[0].points[0].note,
            "0.27 ± 0.13 penumbra RMSE\n1.0 [0, 2.6] fetches per pixel\nmean of 2 scenes");
}

double length_to(const Box& box, const LabelRequest& r) {
  const auto [x, y] = line_end(r, box);
  return std::hypot(x - r.x, y - r.y);
}

// The points lie as those of real fronts do: dense at the cheap end, in the frame's corners, presets close
// together.
TEST(Labels, StayInTheFrameAndOffEachOtherAndSayTheirOwnPoint) {
  std::vector<LabelRequest> requests{{80.0, 30.0, "in the corner"}, {800.0, 280.0, "in the other"},
                                     {250.0, 225.0, "Preset Low"},  {268.0, 227.0, "Preset Medium"},
                                     {278.0, 228.0, "Preset High"}, {293.0, 228.0, "Preset Ultra"}};
  for (int i = 0; i < 12; ++i)
    requests.push_back({100.0 + 50.0 * i, 60.0 + 200.0 / (i + 1.0), "technique-" + std::to_string(i)});
  std::vector<Box> obstacles;
  for (const LabelRequest& r : requests) obstacles.push_back({r.x - 5.0, r.y - 5.0, r.x + 5.0, r.y + 5.0});
  const Box frame{80.0, 30.0, 800.0, 280.0};
  const auto labels = place_labels(requests, obstacles, {}, frame, 12.0);
  ASSERT_EQ(labels.size(), requests.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    ASSERT_TRUE(labels[i]) << requests[i].text;
    const Box& box = labels[i]->box;
    EXPECT_NEAR(overlap_area(box, frame), (box.right - box.left) * (box.bottom - box.top), 1e-9) << i;
    for (const Box& obstacle : obstacles) EXPECT_EQ(overlap_area(box, obstacle), 0.0) << i;
    for (std::size_t j = 0; j < labels.size(); ++j) {
      if (j == i) continue;
      EXPECT_EQ(overlap_area(box, labels[j]->box), 0.0) << i << " on " << j;
      if (labels[i]->needs_line) continue;
      EXPECT_GT(length_to(box, requests[j]), length_to(box, requests[i])) << i << j;
    }
  }
}

TEST(Labels, WithoutRoomAreOmitted) {
  const std::vector<LabelRequest> requests{{50.0, 20.0, "first"}, {50.0, 20.0, "far too long for the frame"}};
  const auto labels = place_labels(requests, {}, {}, {0.0, 0.0, 100.0, 40.0}, 12.0);
  EXPECT_TRUE(labels[0]);
  EXPECT_FALSE(labels[1]);
}

TEST(ParetoCharts, FetchesHaveAFrontAndOnePanelPerLight) {
  const Chart chart = fetches_chart(synthetic::results());
  ASSERT_EQ(chart.panels.size(), 2U);
  EXPECT_EQ(chart.panels[0].title, "0.53° light");
  EXPECT_EQ(chart.panels[1].title, "2° light");
  EXPECT_EQ(chart.panels[0].points.size(), 4U);
  EXPECT_EQ(chart.panels[0].front, (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(ParetoCharts, TimeRanksOnAGraphicsCardOnly) {
  Results results = synthetic::results();
  const Chart software = time_chart(results);
  ASSERT_EQ(software.panels.size(), 2U);
  EXPECT_TRUE(software.panels[0].front.empty());
  EXPECT_THAT(software.x_label, HasSubstr("CPU time"));
  EXPECT_THAT(software.x_label, HasSubstr("not a ranking"));
  results.is_software = false;
  EXPECT_FALSE(time_chart(results).panels[0].front.empty());
  EXPECT_THAT(time_chart(results).x_label, HasSubstr("GPU time"));
  for (Record& record : results.records) record.time = std::nullopt;
  EXPECT_TRUE(time_chart(results).panels.empty());
}

}  // namespace
}  // namespace penumbra::study
