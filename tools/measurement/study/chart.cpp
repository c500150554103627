#include "study/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "study/html_text.h"

namespace penumbra::study {
namespace {

// Counts the letters of UTF-8: bytes that continue a letter do not count.
std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

// Returns the text's box when its nearest edge or corner is `distance` away from the point, in direction
// `angle`.
Box box_at(const LabelRequest& request, double angle, double distance, double font_pixels) {
  constexpr double kMeanLetterWidth = 0.6;  // width of a sans-serif letter, in font sizes, on the wide side
  const double half_width = 0.5 * kMeanLetterWidth * font_pixels * static_cast<double>(letters(request.text));
  const double half_height = 0.58 * font_pixels;
  const double x = request.x + std::cos(angle) * (distance + half_width);
  const double y = request.y + std::sin(angle) * (distance + half_height);
  return {x - half_width, y - half_height, x + half_width, y + half_height};
}

double distance_to(const Box& box, double x, double y) {
  return std::hypot(x - std::clamp(x, box.left, box.right), y - std::clamp(y, box.top, box.bottom));
}

// The frame's ground in squares of a pixel, each free or taken.
class Ground {
 public:
  explicit Ground(const Box& frame)
      : frame_(frame),
        width_(static_cast<int>(std::ceil(frame.right - frame.left))),
        taken_(static_cast<std::size_t>(width_) *
               static_cast<std::size_t>(std::ceil(frame.bottom - frame.top))) {}

  bool is_free(const Box& box) const {
    if (box.left < frame_.left || box.right > frame_.right || box.top < frame_.top ||
        box.bottom > frame_.bottom)
      return false;
    bool free = true;
    for_each(box, [&](std::size_t square) { free = free && !taken_[square]; });
    return free;
  }

  void take(const Box& box) {
    for_each(box, [&](std::size_t square) { taken_[square] = true; });
  }

 private:
  template <class Visit>
  void for_each(const Box& box, const Visit& visit) const {
    const int height = static_cast<int>(taken_.size()) / std::max(width_, 1);
    const int right = std::min(static_cast<int>(std::ceil(box.right - frame_.left)), width_);
    const int bottom = std::min(static_cast<int>(std::ceil(box.bottom - frame_.top)), height);
    for (int y = std::max(static_cast<int>(box.top - frame_.top), 0); y < bottom; ++y)
      for (int x = std::max(static_cast<int>(box.left - frame_.left), 0); x < right; ++x)
        visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
  }

  Box frame_;
  int width_;
  std::vector<bool> taken_;
};

// Returns the squares under a label's line, without those close to its point, where others may lie.
std::vector<Box> line_squares(const LabelRequest& request, const Box& label) {
  constexpr double kClose = 12.0;
  const auto [x, y] = line_end(request, label);
  const double length = std::hypot(x - request.x, y - request.y);
  std::vector<Box> squares;
  for (double at = kClose; at < length - 1.0; at += 1.0) {
    const double here_x = std::lerp(request.x, x, at / length);
    const double here_y = std::lerp(request.y, y, at / length);
    squares.push_back({here_x - 0.5, here_y - 0.5, here_x + 0.5, here_y + 0.5});
  }
  return squares;
}

// Returns whether no other point is about as near to the label as its own.
bool is_plainly_of(const std::vector<LabelRequest>& requests, std::size_t own, const Box& box) {
  constexpr double kNearer = 5.0;
  const double mine = distance_to(box, requests[own].x, requests[own].y);
  return std::none_of(requests.begin(), requests.end(), [&](const LabelRequest& other) {
    return &other != &requests[own] && distance_to(box, other.x, other.y) < mine + kNearer;
  });
}

std::optional<PlacedLabel> best_place(const std::vector<LabelRequest>& requests, std::size_t own,
                                      double font_pixels, const Ground& for_labels, const Ground& for_lines) {
  constexpr std::array kDistances = {9.0, 12.0, 17.0, 24.0, 33.0, 44.0, 58.0, 75.0, 95.0, 120.0, 150.0};
  constexpr double kNear = 14.0;  // without a line
  constexpr int kDirections = 32;
  std::optional<PlacedLabel> with_line;
  for (const double distance : kDistances) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = (i % 2 == 0 ? i : -i - 1) * std::numbers::pi / kDirections;  // right ones first
      const Box box = box_at(requests[own], angle, distance, font_pixels);
      if (!for_labels.is_free(box)) continue;
      if (distance < kNear && is_plainly_of(requests, own, box)) return PlacedLabel{box, false};
      if (with_line) continue;
      const std::vector<Box> line = line_squares(requests[own], box);
      if (std::all_of(line.begin(), line.end(), [&](const Box& square) { return for_lines.is_free(square); }))
        with_line = PlacedLabel{box, true};
    }
    if (with_line && distance > kNear) break;
  }
  return with_line;
}

std::vector<std::optional<PlacedLabel>> placed_in_order(const std::vector<LabelRequest>& requests,
                                                        const std::vector<std::size_t>& order,
                                                        const std::vector<Box>& marks,
                                                        const std::vector<Box>& steps, const Box& frame,
                                                        double font_pixels) {
  Ground for_lines(frame);
  for (const Box& mark : marks) for_lines.take(mark);
  Ground for_labels = for_lines;
  for (const Box& step : steps) for_labels.take(step);
  std::vector<std::optional<PlacedLabel>> labels(requests.size());
  for (const std::size_t i : order) {
    labels[i] = best_place(requests, i, font_pixels, for_labels, for_lines);
    if (!labels[i]) continue;
    for_labels.take(labels[i]->box);
    for_lines.take(labels[i]->box);
    if (!labels[i]->needs_line) continue;
    for (const Box& square : line_squares(requests[i], labels[i]->box)) for_labels.take(square);
  }
  return labels;
}

constexpr double kFont = 13.0;
constexpr double kLabelFont = 12.0;

// Sizes in pixels.
struct Layout {
  bool is_page = false;  // a page has titles of its own
  double width = 820.0;
  double panel_height = 340.0;
  double title_height = 40.0;
  double left = 72.0;  // of a panel's axes from its edges
  double right = 20.0;
  double top = 30.0;
  double bottom = 56.0;
};

constexpr Layout kPage{true, 380.0, 340.0, 0.0, 58.0, 10.0, 10.0, 50.0};

// A file has no other page to take its colours from.
constexpr std::string_view kFileStyle =
    "<style>text { fill: #33363b; } .title { fill: #1b1d21; } .ground { fill: #fcfcfb; }\n"
    ".axis { fill: none; stroke: #6b6f76; } .grid { fill: none; stroke: #e3e4e6; }\n"
    ".leader { fill: none; stroke: #9a9da3; stroke-width: .7; } .step { fill: none; stroke: #7fb2de; "
    "stroke-width: 1.5; }\n"
    ".mark { fill: none; stroke: #777b82; } .front .mark { fill: #0b4f8a; stroke: none; }\n"
    ".name { fill: #55585e; } .front.name { fill: #0b4f8a; }</style>\n";

struct Spot {  // pixels
  double x = 0.0;
  double y = 0.0;
};

struct Axes {
  double least_x = std::numeric_limits<double>::infinity();
  double most_x = 0.0;
  double most_y = 0.0;

  Spot spot(double x, double y, const Box& frame) const {
    return {std::lerp(frame.left, frame.right, std::log(x / least_x) / std::log(most_x / least_x)),
            std::lerp(frame.bottom, frame.top, y / most_y)};
  }
};

bool is_drawn(const ChartPoint& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && point.x > 0.0;
}

// All panels have the same axes, so that they can be compared.
Axes axes_of(const Chart& chart) {
  Axes axes;
  for (const ChartPanel& panel : chart.panels) {
    for (const ChartPoint& point : panel.points) {
      if (!is_drawn(point)) continue;
      axes.least_x = std::min(axes.least_x, point.x);
      axes.most_x = std::max(axes.most_x, point.x);
      axes.most_y = std::max(axes.most_y, point.y);
    }
  }
  if (axes.most_x == 0.0) throw std::invalid_argument("a chart without a point to draw");
  return {axes.least_x / 1.6, axes.most_x * 1.6, axes.most_y > 0.0 ? axes.most_y * 1.15 : 1.0};
}

struct Tick {
  double value = 0.0;
  bool has_label = true;
};

// Returns the figures 1 to 9 of each power of ten; a range below two powers has labels at 2 and 5, too.
std::vector<Tick> logarithmic_ticks(double from, double to) {
  std::vector<Tick> ticks;
  const bool is_narrow = to < 100.0 * from;
  for (double power = std::pow(10.0, std::floor(std::log10(from))); power <= to; power *= 10.0) {
    for (int digit = 1; digit < 10; ++digit) {
      if (digit * power < from || digit * power > to) continue;
      ticks.push_back({digit * power, digit == 1 || (is_narrow && (digit == 2 || digit == 5))});
    }
  }
  return ticks;
}

// Returns multiples of 1, 2 or 5 times a power of ten, about five.
std::vector<Tick> linear_ticks(double to) {
  const double power = std::pow(10.0, std::floor(std::log10(to / 5.0)));
  double step = power;
  for (const double digit : {2.0, 5.0, 10.0}) step = to / step > 7.0 ? digit * power : step;
  std::vector<Tick> ticks;
  for (int i = 0; i * step <= to; ++i) ticks.push_back({i * step});
  return ticks;
}

std::string text_at(double x, double y, std::string_view attributes, std::string_view text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>", x, y, attributes, escape_html(text));
}

class Panel {
 public:
  Panel(const Chart& chart, const ChartPanel& panel, const Axes& axes, const Layout& layout, double top)
      : chart_(chart), panel_(panel), axes_(axes), layout_(layout) {
    frame_ = {layout.left, top + layout.top, layout.width - layout.right,
              top + layout.panel_height - layout.bottom};
    std::copy_if(panel.front.begin(), panel.front.end(), std::back_inserter(front_),
                 [&](std::size_t i) { return is_drawn(panel.points.at(i)); });
    on_front_.resize(panel.points.size());
    for (const std::size_t i : front_) on_front_[i] = true;
  }

  std::string svg() const { return axes() + front() + labels() + points(); }

 private:
  Spot spot(std::size_t point) const {
    return axes_.spot(panel_.points[point].x, panel_.points[point].y, frame_);
  }

  // Calls visit(index) for each point that is drawn, those of the front first.
  template <class Visit>
  void for_each_point(const Visit& visit) const {
    for (const bool front : {true, false})
      for (std::size_t i = 0; i < panel_.points.size(); ++i)
        if (is_drawn(panel_.points[i]) && on_front_[i] == front) visit(i);
  }

  std::string axes() const {
    constexpr double kTick = 5.0;
    const auto [left, top, right, bottom] = frame_;
    const double middle = (left + right) / 2.0;
    std::string texts, grid;
    std::string lines = fmt::format("M{:.1f} {:.1f}V{:.1f}H{:.1f}", left, top, bottom, right);
    for (const Tick& tick : logarithmic_ticks(axes_.least_x, axes_.most_x)) {
      const double x = axes_.spot(tick.value, 0.0, frame_).x;
      lines += fmt::format("M{:.1f} {:.1f}v{}", x, bottom, tick.has_label ? kTick : kTick / 2.0);
      if (!tick.has_label) continue;
      grid += fmt::format("M{:.1f} {:.1f}V{:.1f}", x, top, bottom);
      texts += text_at(x, bottom + kTick + kFont, "text-anchor=\"middle\"", fmt::format("{:g}", tick.value));
    }
    for (const Tick& tick : linear_ticks(axes_.most_y)) {
      const double y = axes_.spot(axes_.most_x, tick.value, frame_).y;
      lines += fmt::format("M{:.1f} {:.1f}h{}", left, y, -kTick);
      grid += fmt::format("M{:.1f} {:.1f}H{:.1f}", left, y, right);
      texts += text_at(left - kTick - 4.0, y + 4.5, "text-anchor=\"end\"", fmt::format("{:.3g}", tick.value));
    }
    if (!layout_.is_page)
      texts += text_at(middle, top - 12.0, "class=\"title\" text-anchor=\"middle\"", panel_.title);
    texts += text_at(middle, bottom + 2.8 * kFont, "text-anchor=\"middle\"", chart_.x_label);
    texts += text_at(0.0, 0.0,
                     fmt::format("text-anchor=\"middle\" transform=\"translate({:.1f},{:.1f}) rotate(-90)\"",
                                 layout_.is_page ? kFont : left - 4.0 * kFont, (top + bottom) / 2.0),
                     chart_.y_label);
    return fmt::format("<path class=\"grid\" d=\"{}\"/>\n<path class=\"axis\" d=\"{}\"/>\n{}\n", grid, lines,
                       texts);
  }

  // Between two points of the front the error stays the cheaper one's.
  std::string front() const {
    std::string path;
    for (const std::size_t i : front_) {
      const auto [x, y] = spot(i);
      path += fmt::format(fmt::runtime(path.empty() ? "M{:.1f} {:.1f}" : "H{:.1f}V{:.1f}"), x, y);
    }
    return path.empty() ? "" : "<path class=\"step\" d=\"" + path + "\"/>\n";
  }

  static Box around(Spot from, Spot to, double radius) {
    return {std::min(from.x, to.x) - radius, std::min(from.y, to.y) - radius, std::max(from.x, to.x) + radius,
            std::max(from.y, to.y) + radius};
  }

  std::vector<Box> marks() const {
    std::vector<Box> boxes;
    for_each_point([&](std::size_t i) { boxes.push_back(around(spot(i), spot(i), 5.0)); });
    return boxes;
  }

  std::vector<Box> steps() const {
    std::vector<Box> boxes;
    for (std::size_t i = 1; i < front_.size(); ++i) {
      const Spot before = spot(front_[i - 1]);
      const Spot after = spot(front_[i]);
      boxes.push_back(around(before, {after.x, before.y}, 2.0));
      boxes.push_back(around({after.x, before.y}, after, 2.0));
    }
    return boxes;
  }

  std::string labels() const {
    constexpr std::size_t kMostTried = 100;  // every place of a label is tried against all points
    std::vector<LabelRequest> requests;
    for_each_point([&](std::size_t i) {
      if (requests.size() == kMostTried) return;
      requests.push_back({spot(i).x, spot(i).y, panel_.points[i].label, on_front_[i]});
    });
    const auto places = place_labels(requests, marks(), steps(), frame_, kLabelFont);
    std::string lines, texts;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!places[i]) continue;
      const Box& box = places[i]->box;
      texts += text_at((box.left + box.right) / 2.0, (box.top + box.bottom) / 2.0 + 0.36 * kLabelFont,
                       fmt::format("class=\"{}name\" font-size=\"{}\" text-anchor=\"middle\"",
                                   requests[i].is_important ? "front " : "", kLabelFont),
                       requests[i].text);
      const auto [x, y] = line_end(requests[i], box);
      if (places[i]->needs_line)
        lines += fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", requests[i].x, requests[i].y, x, y);
    }
    return (lines.empty() ? "" : "<path class=\"leader\" d=\"" + lines + "\"/>\n") + texts + "\n";
  }

  std::string points() const {
    std::string others, front;
    for_each_point([&](std::size_t i) {
      const ChartPoint& point = panel_.points[i];
      const auto [x, y] = spot(i);
      const std::string label = escape_html(point.label);
      const std::string note = escape_html(point.note);
      const std::string kind = on_front_[i] ? "point front" : "point";
      const std::string mark = fmt::format("<circle class=\"mark\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>", x,
                                           y, on_front_[i] ? "3.5" : "3");
      (on_front_[i] ? front : others) +=
          layout_.is_page ? fmt::format(
                                "<a class=\"{}\" href=\"#figures\" data-technique=\"{}\" data-label=\"{}\" "
                                "data-note=\"{}\" aria-label=\"{}: {}\">{}"
                                "<circle class=\"reach\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"11\"/>"
                                "<circle class=\"ring\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"6\"/></a>",
                                kind, escape_html(point.name), label, note, label, note, mark, x, y, x, y)
                          : fmt::format("<g class=\"{}\">{}<title>{}{}{}</title></g>", kind, mark, label,
                                        note.empty() ? "" : "&#10;", note);
    });
    return "<g class=\"points\">" + others + front + "</g>\n";
  }

  const Chart& chart_;
  const ChartPanel& panel_;
  const Axes& axes_;
  const Layout& layout_;
  Box frame_;
  std::vector<std::size_t> front_;  // without points that are not drawn
  std::vector<bool> on_front_;
};

std::string canvas(const Layout& layout, double height, const std::string& attributes,
                   const std::string& content) {
  return fmt::format(
             "<svg{} viewBox=\"0 0 {} {}\" font-family=\"sans-serif\" font-size=\"{}\">\n{}"
             "<rect class=\"ground\" width=\"{}\" height=\"{}\"/>\n",
             attributes, layout.width, height, kFont, layout.is_page ? "" : kFileStyle, layout.width,
             height) +
         content + "</svg>\n";
}

}  // namespace

std::string render_svg(const Chart& chart) {
  const Axes axes = axes_of(chart);
  Layout layout;
  for (const ChartPanel& panel : chart.panels)
    if (panel.points.size() > 12) layout.panel_height = 480.0;  // for their labels
  double height = layout.title_height;
  const std::string title = escape_html(chart.title);
  std::string content = "<title>" + title + "</title>\n" +
                        text_at(layout.width / 2.0, 24.0,
                                "class=\"title\" font-size=\"16\" text-anchor=\"middle\"", chart.title) +
                        "\n";
  for (const ChartPanel& panel : chart.panels) {
    content += Panel(chart, panel, axes, layout, height).svg();
    height += layout.panel_height;
  }
  return canvas(layout, height, " xmlns=\"http://www.w3.org/2000/svg\"", content);
}

std::vector<std::string> render_panels(const Chart& chart) {
  const Axes axes = axes_of(chart);
  std::vector<std::string> drawn;
  for (const ChartPanel& panel : chart.panels)
    drawn.push_back(canvas(kPage, kPage.panel_height,
                           fmt::format(" role=\"group\" aria-label=\"{}\"", escape_html(panel.title)),
                           Panel(chart, panel, axes, kPage, 0.0).svg()));
  return drawn;
}

double overlap_area(const Box& a, const Box& b) {
  return std::max(std::min(a.right, b.right) - std::max(a.left, b.left), 0.0) *
         std::max(std::min(a.bottom, b.bottom) - std::max(a.top, b.top), 0.0);
}

std::pair<double, double> line_end(const LabelRequest& request, const Box& label) {
  return {std::clamp(request.x, label.left, label.right), std::clamp(request.y, label.top, label.bottom)};
}

std::vector<std::optional<PlacedLabel>> place_labels(const std::vector<LabelRequest>& requests,
                                                     const std::vector<Box>& marks,
                                                     const std::vector<Box>& steps, const Box& frame,
                                                     double font_pixels) {
  constexpr int kOrders = 16;
  std::vector<std::size_t> order(requests.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<std::optional<PlacedLabel>> best(requests.size());
  std::ptrdiff_t most = -1;
  for (int i = 0; i < kOrders; ++i) {
    const auto labels = placed_in_order(requests, order, marks, steps, frame, font_pixels);
    const auto is_missing = [&](std::size_t label) { return requests[label].is_important && !labels[label]; };
    const auto missing = std::find_if(order.begin(), order.end(), is_missing);
    const auto found = std::count_if(order.begin(), order.end(), std::not_fn(is_missing));
    if (found > most) best = labels;
    most = std::max(most, found);
    if (missing == order.end()) break;
    std::rotate(order.begin(), missing, missing + 1);  // it comes first
  }
  return best;
}

}  // namespace penumbra::study
