#include "study/chart.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <regex>

#include "input/input_error.h"
#include "processor_time.h"
#include "study/chart_labels.h"
#include "study/pareto_chart.h"
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
  return {"small", "A title", "cost",
          "error", true,      {{"one light", {{"cheap", 1.0, 0.3}, {"good", 90.0, 0.1}}, {0, 1}}}};
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
  for (const char* text : {">A title<", ">one light<", ">cheap<", ">good<", ">cost<", ">error<"}) {
    EXPECT_EQ(count(svg, text), text == std::string(">A title<") ? 2 : 1)
        << text;  // the title is also <title>
  }
}

TEST(Chart, TheSameChartIsTheSameBytesAndNamesNoProgram) {
  const std::string svg = render_svg(small_chart());
  EXPECT_EQ(svg, render_svg(small_chart()));
  EXPECT_THAT(svg, Not(HasSubstr("GNUPLOT")));
  EXPECT_THAT(svg, Not(HasSubstr("patchlevel")));
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
  EXPECT_EQ(count(svg, "a ]]&gt; b"), 6) << "the title is also <title>";
  for (const DrawnPanel& panel : render_panels(chart)) EXPECT_EQ(xml_fault(panel.svg), "");
}

TEST(Chart, SeveralOnOnePageShareNoId) {
  Chart other = small_chart();
  other.name = "other";
  const std::string first = render_svg(small_chart());
  const std::string second = render_svg(other);
  for (const char quote : {'\'', '"'}) {
    const std::string key = std::string(" id=") + quote;
    for (std::size_t at = first.find(key); at != std::string::npos; at = first.find(key, at + 1)) {
      const std::string id = first.substr(at, first.find(quote, at + key.size()) - at + 1);
      EXPECT_THAT(second, Not(HasSubstr(id)));
    }
  }
  // Every identifier that is referred to is there.
  for (std::size_t at = first.find("href='#"); at != std::string::npos; at = first.find("href='#", at + 1)) {
    const std::string id = first.substr(at + 7, first.find('\'', at + 7) - at - 7);
    EXPECT_THAT(first, HasSubstr("id='" + id + "'"));
  }
}

TEST(Chart, LeavesOutWhatHasNoPlace) {
  Chart chart = small_chart();
  chart.panels[0].points.push_back({"nowhere", std::nan(""), 0.1});
  chart.panels[0].points.push_back({"free", 0.0, 0.1});
  const std::string svg = render_svg(chart);
  EXPECT_THAT(svg, Not(HasSubstr("nowhere")));
  EXPECT_THAT(svg, Not(HasSubstr("free")));
  chart.x_logarithmic = false;
  EXPECT_THAT(render_svg(chart), HasSubstr("free"));
  chart.panels[0].points.clear();
  chart.panels[0].front.clear();
  EXPECT_THROW(render_svg(chart), std::invalid_argument);
}

TEST(Chart, OnePointIsEnough) {
  Chart chart = small_chart();
  chart.panels[0] = {"one light", {{"alone", 5.0, 0.0}}, {0}};
  EXPECT_THAT(render_svg(chart), HasSubstr(">alone<"));
  chart.x_logarithmic = false;
  EXPECT_EQ(xml_fault(render_svg(chart)), "");
}

TEST(Chart, AMissingGnuplotIsSaidWithTheWayOut) {
  const char* path = std::getenv("PATH");
  const std::string before = path == nullptr ? "" : path;
  ASSERT_EQ(::setenv("PATH", "/nonexistent", 1), 0);
  std::string message;
  try {
    render_svg(small_chart());
  } catch (const EnvironmentError& error) {
    message = error.what();
  }
  ASSERT_EQ(::setenv("PATH", before.c_str(), 1), 0);
  EXPECT_THAT(message, HasSubstr("apt-get install gnuplot-nox"));
}

TEST(PagePanels, HaveOneDrawingEachWithThePagesOwnColours) {
  const std::vector<DrawnPanel> panels = render_panels(fetches_chart(synthetic::results()));
  ASSERT_EQ(panels.size(), 2U);
  EXPECT_EQ(panels[1].title, "2° light");
  for (const DrawnPanel& panel : panels) {
    EXPECT_EQ(panel.svg.rfind("<svg", 0), 0U);
    EXPECT_EQ(xml_fault(panel.svg), "");
    EXPECT_THAT(panel.svg, Not(HasSubstr("<title>")));
    EXPECT_THAT(panel.svg, Not(HasSubstr("2° light"))) << "the page writes the title";
    for (const char* name : {"ground", "tick", "axis", "grid", "point", "front", "step"}) {
      EXPECT_THAT(panel.svg, HasSubstr("var(--chart-" + std::string(name) + ")"));
    }
  }
  EXPECT_THAT(panels[0].svg, HasSubstr("fetches-0-gpDot"));
  EXPECT_THAT(panels[1].svg, HasSubstr("fetches-1-gpDot")) << "ids of one page differ";
}

TEST(PagePanels, PointsLieWhereGnuplotDrewThem) {
  const std::vector<DrawnPanel> panels = render_panels(fetches_chart(synthetic::results()));
  for (const DrawnPanel& panel : panels) {
    ASSERT_EQ(panel.points.size(), 4U);
    for (const DrawnPoint& point : panel.points) {
      EXPECT_TRUE(point.on_front);
      EXPECT_GT(point.x, 0.0);
      EXPECT_LT(point.x, panel.width);
      EXPECT_GT(point.y, 0.0);
      EXPECT_LT(point.y, panel.height);
      // The places agree within half a pixel, because gnuplot writes hundredths.
      const std::regex drawn("translate\\(([0-9.]+),([0-9.]+)\\) scale");
      bool found = false;
      for (auto match = std::sregex_iterator(panel.svg.begin(), panel.svg.end(), drawn);
           match != std::sregex_iterator(); ++match) {
        found = found || (std::abs(std::stod((*match)[1]) - point.x) < 0.5 &&
                          std::abs(std::stod((*match)[2]) - point.y) < 0.5);
      }
      EXPECT_TRUE(found) << point.x << " " << point.y;
    }
  }
}

TEST(PagePanels, LabelTwelvePointsAndOfMoreThoseThatFindRoom) {
  Chart chart = small_chart();
  const auto labels_of = [&chart](int points) {
    chart.panels = {{"one light", {}, {0}}};
    for (int i = 0; i < points; ++i) {
      chart.panels[0].points.push_back({"technique " + std::to_string(i), 10.0 + i, 0.1 + 0.001 * i});
    }
    const std::string svg = render_panels(chart)[0].svg;
    EXPECT_THAT(svg, HasSubstr(">technique 0<")) << "the front";
    return count(svg, ">technique ");
  };
  EXPECT_EQ(labels_of(12), 12);
  const int of_sixty = labels_of(60);
  EXPECT_GE(of_sixty, 12);
  EXPECT_LT(of_sixty, 60);
}

// Every place of a label is tried against the other labels, several times: of very many points those of the
// front have labels, and of these as many as there could be room for.
TEST(PagePanels, OfVeryManyPointsTheFrontAloneHasLabels) {
  Chart chart = small_chart();
  const auto labels_of = [&chart](std::size_t points, std::size_t on_front) {
    chart.panels = {{"one light", {}, {}}};
    for (std::size_t i = 0; i < points; ++i) {
      const double share = static_cast<double>(i % 997) / 997.0;
      chart.panels[0].points.push_back(
          {"technique " + std::to_string(i), 10.0 + 100.0 * share, 0.5 - 0.4 * share});
      if (i < on_front) chart.panels[0].front.push_back(i);
    }
    const std::vector<DrawnPanel> drawn = render_panels(chart);
    EXPECT_EQ(drawn[0].points.size(), points);
    return count(drawn[0].svg, ">technique ");
  };
  const double seconds = processor_seconds([&] {
    EXPECT_EQ(labels_of(20'000, 5), 5);
    EXPECT_EQ(labels_of(2'000, 2'000), 24);
  });
  EXPECT_LT(seconds, 20.0) << "what grows with the cube takes hours";
}

TEST(ParetoCharts, APointSaysItsFiguresAndHowManyScenesItIsAMeanOf) {
  const Chart chart = fetches_chart(synthetic::results());
  EXPECT_EQ(chart.panels[0].points[0].note,
            "0.27 ± 0.13 penumbra RMSE\n1.0 [0, 2.6] fetches per pixel\nmean of 2 scenes");
}

TEST(Labels, StayInTheFrameAndOffEachOther) {
  // The front is as it really comes: dense at the cheap end, and with two points at the frame's own corners.
  std::vector<LabelRequest> requests;
  std::vector<Box> obstacles;
  requests.reserve(14);
  obstacles.reserve(14);
  for (int i = 0; i < 12; ++i) {
    requests.push_back({100.0 + 50.0 * i, 60.0 + 200.0 / (i + 1.0), "technique-" + std::to_string(i)});
  }
  requests.push_back({80.0, 30.0, "in the corner"});
  requests.push_back({800.0, 280.0, "in the other"});
  for (const LabelRequest& r : requests) obstacles.push_back({r.x - 5.0, r.y - 5.0, r.x + 5.0, r.y + 5.0});
  const Box frame{80.0, 30.0, 800.0, 280.0};
  const auto labels = place_labels(requests, obstacles, frame, 12.0);
  ASSERT_EQ(labels.size(), requests.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Box& box = labels[i]->box;
    EXPECT_GE(box.left, frame.left) << i;
    EXPECT_LE(box.right, frame.right) << i;
    EXPECT_GE(box.top, frame.top) << i;
    EXPECT_LE(box.bottom, frame.bottom) << i;
    for (const Box& obstacle : obstacles) EXPECT_EQ(overlap_area(box, obstacle), 0.0) << i;
    for (std::size_t j = 0; j < i; ++j) EXPECT_EQ(overlap_area(box, labels[j]->box), 0.0) << i << " on " << j;
  }
}

// Four presets close together on a flat front, as a light of 0.53 degrees brings them.
TEST(Labels, OfANeighbourNoneStandsAtAPointWithoutALine) {
  const std::vector<LabelRequest> requests{{250.0, 225.0, "Preset Low"},
                                           {268.0, 227.0, "Preset Medium"},
                                           {278.0, 228.0, "Preset High"},
                                           {293.0, 228.0, "Preset Ultra"}};
  std::vector<Box> obstacles;
  for (const LabelRequest& r : requests) obstacles.push_back({r.x - 5.0, r.y - 5.0, r.x + 5.0, r.y + 5.0});
  const auto labels = place_labels(requests, obstacles, {58.0, 10.0, 370.0, 290.0}, 12.0);
  const auto distance = [](const Box& box, const LabelRequest& r) {
    return std::hypot(r.x - std::clamp(r.x, box.left, box.right), r.y - std::clamp(r.y, box.top, box.bottom));
  };
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i]->needs_line) continue;
    for (std::size_t j = 0; j < requests.size(); ++j) {
      if (j == i) continue;
      EXPECT_GT(distance(labels[i]->box, requests[j]), distance(labels[i]->box, requests[i]))
          << requests[i].text << " at " << requests[j].text;
    }
  }
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
