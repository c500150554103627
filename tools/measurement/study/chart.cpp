#include "study/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "input/input_error.h"
#include "platform/child_process.h"
#include "study/chart_labels.h"

namespace penumbra::study {
namespace {

constexpr double kFont = 13.0;

// Sizes in pixels. The distances between a panel's edge and its axes are fixed, not gnuplot's choice, so that
// labels can be placed in pixels beforehand.
struct Layout {
  double width = 820.0;
  double panel_height = 340.0;
  double title_height = 40.0;  // 0 draws the chart without its title and those of its panels
  double left = 82.0;
  double right = 20.0;
  double top = 30.0;
  double bottom = 56.0;
  bool drops_labels = false;  // beyond kAlwaysLabelled, labels of dominated points without room
};

constexpr Layout kFile{};
constexpr Layout kPage{380.0, 340.0, 0.0, 58.0, 10.0, 10.0, 50.0, true};
constexpr std::size_t kAlwaysLabelled = 12;  // points of a panel

// A panel of more points names those of the front alone, and of these so many: the places of labels are tried
// against each other, and there would be no room. The page's table has all names.
constexpr std::size_t kMostPlaced = 96;
constexpr std::size_t kMostOfFront = 24;

namespace ink {
constexpr std::string_view kGround = "#fcfcfb";
constexpr std::string_view kTitle = "#1b1d21";
constexpr std::string_view kTick = "#33363b";
constexpr std::string_view kAxis = "#6b6f76";
constexpr std::string_view kGrid = "#e3e4e6";
constexpr std::string_view kPoint = "#8a8d93";
constexpr std::string_view kOther = "#55585e";
constexpr std::string_view kLeader = "#9a9da3";
constexpr std::string_view kFront = "#0b4f8a";
constexpr std::string_view kStep = "#7fb2de";
}  // namespace ink

// These are the page's CSS variables for each colour.
constexpr std::pair<std::string_view, std::string_view> kVariables[] = {
    {ink::kGround, "ground"}, {ink::kTitle, "ink"},   {ink::kTick, "tick"},  {ink::kAxis, "axis"},
    {ink::kGrid, "grid"},     {ink::kPoint, "point"}, {ink::kOther, "tick"}, {ink::kLeader, "axis"},
    {ink::kFront, "front"},   {ink::kStep, "step"}};

struct Axis {
  double from = 0.0;
  double to = 1.0;
  bool logarithmic = false;

  double share(double value) const {
    if (!logarithmic) return (value - from) / (to - from);
    return std::log(value / from) / std::log(to / from);
  }
};

struct Spot {  // pixels
  double x = 0.0;
  double y = 0.0;
};

struct Axes {
  Axis x;
  Axis y;
};

bool is_drawn(const Chart& chart, const ChartPoint& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && (!chart.x_logarithmic || point.x > 0.0);
}

// All panels have the same axes, so that they can be compared.
Axes axes_of(const Chart& chart) {
  double least_x = std::numeric_limits<double>::infinity();
  double most_x = -least_x;
  double most_y = 0.0;
  for (const ChartPanel& panel : chart.panels) {
    for (const ChartPoint& point : panel.points) {
      if (!is_drawn(chart, point)) continue;
      least_x = std::min(least_x, point.x);
      most_x = std::max(most_x, point.x);
      most_y = std::max(most_y, point.y);
    }
  }
  if (!(least_x <= most_x)) throw std::invalid_argument("a chart without a point to draw");
  Axes axes;
  axes.x = chart.x_logarithmic ? Axis{least_x / 1.6, most_x * 1.6, true} : Axis{0.0, most_x * 1.15, false};
  if (axes.x.to <= axes.x.from) axes.x.to = axes.x.from + 1.0;
  axes.y = {0.0, most_y > 0.0 ? most_y * 1.15 : 1.0, false};
  return axes;
}

// Returns a gnuplot string. Quotes, and the characters that gnuplot replaces in a string, are written by
// their octal codes: two single quotes in a row end a string in single quotes. Control characters would end
// the command.
std::string gnuplot_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    const bool special = c == '"' || c == '\'' || c == '\\' || c == '`';
    result += code < 32 ? " " : special ? fmt::format("\\{:03o}", code) : std::string(1, c);
  }
  return result + "\"";
}

// Returns for each point whether it is on the front.
std::vector<bool> on_front(const ChartPanel& panel) {
  std::vector<bool> marked(panel.points.size());
  for (const std::size_t point : panel.front) marked.at(point) = true;
  return marked;
}

class Script {
 public:
  Script(const Chart& chart, const Axes& axes, const Layout& layout)
      : chart_(chart), axes_(axes), layout_(layout) {
    height_ = layout.title_height + layout.panel_height * static_cast<double>(chart.panels.size());
    text_ += fmt::format(
        "set encoding utf8\n"
        "set terminal svg size {},{} dynamic noenhanced font 'sans-serif,{}' background '{}'\n"
        "set multiplot\nset border 3 linecolor '{}'\nset tics nomirror textcolor '{}' scale 0.6\n"
        "set grid linecolor '{}' linewidth 1\nunset key\n",
        layout.width, height_, kFont, ink::kGround, ink::kAxis, ink::kTick, ink::kGrid);
    if (!has_titles()) return;
    text_ +=
        fmt::format("set label 9999 {} at screen {:.5f},{:.5f} center textcolor '{}' font ',16'\n",
                    gnuplot_string(chart.title), 0.5, 1.0 - layout.title_height / 2.0 / height_, ink::kTitle);
  }

  std::string draw() {
    for (std::size_t i = 0; i < chart_.panels.size(); ++i) draw_panel(i);
    return text_ + "unset multiplot\n";
  }

  Box frame(std::size_t panel) const {
    const double top = layout_.title_height + layout_.panel_height * static_cast<double>(panel);
    return {layout_.left, top + layout_.top, layout_.width - layout_.right,
            top + layout_.panel_height - layout_.bottom};
  }

  Spot spot(const ChartPoint& point, const Box& frame) const {
    return {std::lerp(frame.left, frame.right, axes_.x.share(point.x)),
            std::lerp(frame.bottom, frame.top, axes_.y.share(point.y))};
  }

 private:
  bool has_titles() const { return layout_.title_height > 0.0; }
  double screen_x(double pixels) const { return pixels / layout_.width; }
  double screen_y(double pixels) const { return 1.0 - pixels / height_; }

  void draw_panel(std::size_t index) {
    const ChartPanel& panel = chart_.panels[index];
    const Box frame = this->frame(index);
    text_ += fmt::format(
        "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
        "set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n",
        screen_x(frame.left), screen_x(frame.right), screen_y(frame.top), screen_y(frame.bottom));
    if (has_titles()) {
      text_ += fmt::format("set title {} offset 0,-0.6 textcolor '{}'\n", gnuplot_string(panel.title),
                           ink::kTitle);
    }
    text_ += fmt::format(
        "set xlabel {} offset 0,0.4 textcolor '{}'\n{}set xrange [{:.9g}:{:.9g}]\nset yrange "
        "[{:.9g}:{:.9g}]\n",
        gnuplot_string(chart_.x_label), ink::kTick, axes_.x.logarithmic ? "set logscale x\n" : "",
        axes_.x.from, axes_.x.to, axes_.y.from, axes_.y.to);
    add_y_label(frame);
    add_labels(panel, frame);
    add_data(panel);
    // Labels and leader lines belong to one panel only.
    text_ += "unset label\nunset arrow\n";
  }

  // The label stands at a fixed place in a page's narrow panel: gnuplot would move it by the width of the
  // tics, beyond the edge.
  void add_y_label(const Box& frame) {
    constexpr double kFromEdge = 10.0;
    const std::string label = gnuplot_string(chart_.y_label);
    text_ += has_titles()
                 ? fmt::format("set ylabel {} offset 1.5,0 textcolor '{}'\n", label, ink::kTick)
                 : fmt::format("set label {} at screen {:.5f},{:.5f} center rotate textcolor '{}'\n", label,
                               screen_x(kFromEdge), screen_y((frame.top + frame.bottom) / 2.0), ink::kTick);
  }

  // Obstacles for labels: the points, and the steps of the front (horizontal first, then vertical).
  std::vector<Box> obstacles(const ChartPanel& panel, const Box& frame, bool front_alone) const {
    constexpr double kPointRadius = 5.0;
    constexpr double kLineRadius = 2.0;
    std::vector<Box> boxes;
    const auto add = [&boxes](Spot from, Spot to, double radius) {
      boxes.push_back({std::min(from.x, to.x) - radius, std::min(from.y, to.y) - radius,
                       std::max(from.x, to.x) + radius, std::max(from.y, to.y) + radius});
    };
    const std::vector<bool> front = on_front(panel);
    const std::size_t most = front_alone ? kMostOfFront : kMostPlaced;
    for (std::size_t i = 0; i < panel.points.size(); ++i) {
      const ChartPoint& point = panel.points[i];
      if (is_drawn(chart_, point) && (!front_alone || front[i]) && boxes.size() < most)
        add(spot(point, frame), spot(point, frame), kPointRadius);
    }
    for (std::size_t i = 1; i < std::min(panel.front.size(), most); ++i) {
      const Spot before = spot(panel.points.at(panel.front[i - 1]), frame);
      const Spot after = spot(panel.points.at(panel.front[i]), frame);
      add(before, {after.x, before.y}, kLineRadius);
      add({after.x, before.y}, after, kLineRadius);
    }
    return boxes;
  }

  struct Labels {
    std::vector<LabelRequest> requests;  // the points of the front come first
    std::size_t of_front = 0;
    std::vector<std::optional<PlacedLabel>> places;
  };

  Labels placed_labels(const ChartPanel& panel, const Box& frame) const {
    Labels labels;
    const std::vector<bool> is_on_front = on_front(panel);
    const bool front_alone = panel.points.size() > kMostPlaced;
    for (const bool front : {true, false}) {
      for (std::size_t i = 0; i < panel.points.size(); ++i) {
        const ChartPoint& point = panel.points[i];
        if (!is_drawn(chart_, point) || is_on_front[i] != front) continue;
        if (front_alone && (!front || labels.requests.size() == kMostOfFront)) break;
        const Spot at = spot(point, frame);
        labels.requests.push_back({at.x, at.y, point.label});
      }
      if (front) labels.of_front = labels.requests.size();
    }
    const std::size_t always =
        layout_.drops_labels ? std::max(kAlwaysLabelled, labels.of_front) : labels.requests.size();
    labels.places =
        place_labels(labels.requests, obstacles(panel, frame, front_alone), frame, kFont - 1.0, always);
    return labels;
  }

  void add_labels(const ChartPanel& panel, const Box& frame) {
    const Labels all = placed_labels(panel, frame);
    const std::vector<LabelRequest>& requests = all.requests;
    const std::vector<std::optional<PlacedLabel>>& labels = all.places;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (!labels[i]) continue;
      const Box& box = labels[i]->box;
      const double x = (box.left + box.right) / 2.0;
      const double y = (box.top + box.bottom) / 2.0;
      text_ += fmt::format("set label {} at screen {:.5f},{:.5f} center front font ',{}' textcolor '{}'\n",
                           gnuplot_string(requests[i].text), screen_x(x), screen_y(y), kFont - 1.0,
                           i < all.of_front ? ink::kFront : ink::kOther);
      if (!labels[i]->needs_line) continue;
      const double end_x = std::clamp(requests[i].x, box.left, box.right);
      const double end_y = std::clamp(requests[i].y, box.top, box.bottom);
      text_ += fmt::format(
          "set arrow from screen {:.5f},{:.5f} to screen {:.5f},{:.5f} nohead linecolor '{}' linewidth "
          "0.7\n",
          screen_x(requests[i].x), screen_y(requests[i].y), screen_x(end_x), screen_y(end_y), ink::kLeader);
    }
  }

  void add_data(const ChartPanel& panel) {
    std::string all;
    std::string front;
    for (const ChartPoint& point : panel.points) {
      if (is_drawn(chart_, point)) all += fmt::format("{:.9g} {:.9g}\n", point.x, point.y);
    }
    for (const std::size_t i : panel.front) {
      const ChartPoint& point = panel.points.at(i);
      if (is_drawn(chart_, point)) front += fmt::format("{:.9g} {:.9g}\n", point.x, point.y);
    }
    if (all.empty()) all = "NaN NaN\n";
    text_ += "$all << END_OF_POINTS\n" + all + "END_OF_POINTS\n";
    std::string plot =
        fmt::format("plot $all with points pointtype 6 pointsize 0.6 linecolor '{}'", ink::kPoint);
    if (!front.empty()) {
      text_ += "$front << END_OF_POINTS\n" + front + "END_OF_POINTS\n";
      plot += fmt::format(
          ", $front with steps linecolor '{}' linewidth 1.5"
          ", $front with points pointtype 7 pointsize 0.7 linecolor '{}'",
          ink::kStep, ink::kFront);
    }
    text_ += plot + "\n";
  }

  const Chart& chart_;
  Axes axes_;
  Layout layout_;
  double height_ = 0.0;
  std::string text_;
};

void replace_all(std::string& text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
}

// gnuplot names its version in <desc>, and gives every file the same ids: neither may appear in our pages.
std::string make_own(std::string svg, const Chart& chart) {
  const std::size_t description = svg.find("<desc>");
  const std::size_t end = svg.find("</desc>");
  if (description != std::string::npos && end != std::string::npos) {
    svg.erase(description, end + 7 - description);
  }
  std::string title;
  for (const char c : chart.title) {
    title += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  replace_all(svg, "<title>Gnuplot</title>", "<title>" + title + "</title>");
  // gnuplot leaves '>' as it is, and writes no CDATA sections, which alone may end so.
  replace_all(svg, "]]>", "]]&gt;");
  for (const std::string id : {"gpDot", "gpPt", "textbox", "greybox", "gnuplot_"}) {
    replace_all(svg, "id='" + id, "id='" + chart.name + "-" + id);
    replace_all(svg, "id=\"" + id, "id=\"" + chart.name + "-" + id);
    replace_all(svg, "='#" + id, "='#" + chart.name + "-" + id);
    replace_all(svg, "url(#" + id, "url(#" + chart.name + "-" + id);
  }
  return svg;
}

std::string run_gnuplot(const std::string& script, const Chart& chart) {
  require_gnuplot();
  platform::ChildCommand command{"gnuplot", {"-d"}, script};  // -d: no user's settings
  command.timeout = std::chrono::seconds(20);
  const platform::ChildResult result = platform::run_child(command);
  if (!result.succeeded() || result.output.find("</svg>") == std::string::npos) {
    throw EnvironmentError("gnuplot did not draw the chart '" + chart.title + "'" +
                           (result.timed_out ? " within 20 s" : ": " + result.errors));
  }
  return make_own(result.output, chart);
}

void check_name(const Chart& chart) {
  const auto named = [](char c) { return c == '-' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z'); };
  if (chart.name.empty() || !std::all_of(chart.name.begin(), chart.name.end(), named)) {
    throw std::invalid_argument("a chart's name is lower-case letters, digits and '-'");
  }
}

// gnuplot writes a colour as #rrggbb, as rgb(r,g,b) and as rgb(r, g, b) with each number three wide.
void colour_by_variables(std::string& svg) {
  for (const auto& [written_hex, name] : kVariables) {
    const std::string hex(written_hex);
    const auto part = [&hex](std::size_t at) { return std::stoi(hex.substr(at, 2), nullptr, 16); };
    std::string upper = hex;
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](char c) { return c >= 'a' && c <= 'f' ? static_cast<char>(c - 'a' + 'A') : c; });
    const std::string variable = "var(--chart-" + std::string(name) + ")";
    for (const std::string& written : {hex, upper, fmt::format("rgb({},{},{})", part(1), part(3), part(5)),
                                       fmt::format("rgb({:3}, {:3}, {:3})", part(1), part(3), part(5))}) {
      replace_all(svg, written, variable);
    }
  }
}

// gnuplot's own titles would be shown as tooltips, instead of the page's.
void remove_titles(std::string& svg) {
  for (std::size_t at = svg.find("<title>"); at != std::string::npos; at = svg.find("<title>", at)) {
    const std::size_t end = svg.find("</title>", at);
    svg.erase(at, end == std::string::npos ? std::string::npos : end + 8 - at);
  }
}

// Returns the SVG element alone, without the XML prolog that a file needs and a page must not have.
std::string for_page(std::string svg) {
  svg.erase(0, svg.find("<svg"));
  colour_by_variables(svg);
  remove_titles(svg);
  return svg;
}

}  // namespace

void require_gnuplot() {
  if (platform::find_program("gnuplot")) return;
  throw EnvironmentError(
      "gnuplot is needed to draw charts and is not installed\n  apt-get install gnuplot-nox");
}

std::string render_svg(const Chart& chart) {
  check_name(chart);
  return run_gnuplot(Script(chart, axes_of(chart), kFile).draw(), chart);
}

std::vector<DrawnPanel> render_panels(const Chart& chart) {
  check_name(chart);
  const Axes axes = axes_of(chart);
  std::vector<DrawnPanel> drawn;
  for (const ChartPanel& panel : chart.panels) {
    Chart alone = chart;
    alone.name += "-" + std::to_string(drawn.size());
    alone.panels = {panel};
    Script script(alone, axes, kPage);
    DrawnPanel& page = drawn.emplace_back();
    page.title = panel.title;
    page.width = static_cast<int>(kPage.width);
    page.height = static_cast<int>(kPage.panel_height);
    page.svg = for_page(run_gnuplot(script.draw(), alone));
    const std::vector<bool> front = on_front(panel);
    for (std::size_t i = 0; i < panel.points.size(); ++i) {
      if (!is_drawn(chart, panel.points[i])) continue;
      const Spot at = script.spot(panel.points[i], script.frame(0));
      page.points.push_back({i, at.x, at.y, front[i]});
    }
  }
  return drawn;
}

}  // namespace penumbra::study
