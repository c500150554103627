#include "study/chart_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

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

}  // namespace

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
