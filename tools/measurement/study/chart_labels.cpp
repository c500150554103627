#include "study/chart_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

namespace penumbra::study {
namespace {

constexpr double kHasRoom = 60.0;  // cost of a position without overlaps that is clearly at its point

double area(const Box& box) {
  return std::max(box.right - box.left, 0.0) * std::max(box.bottom - box.top, 0.0);
}

// Counts the letters of UTF-8: bytes that continue a letter do not count.
std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

// Returns the text's box when its nearest edge or corner is `distance` away from the point, in direction
// `angle`.
Box box_at(const LabelRequest& request, double angle, double distance, double font_pixels) {
  constexpr double kMeanLetterWidth = 0.58;  // width of a sans-serif letter, in font sizes, on the wide side
  const double width = kMeanLetterWidth * font_pixels * static_cast<double>(letters(request.text));
  const double height = 1.15 * font_pixels;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double x = request.x + c * distance + c * width / 2.0;
  const double y = request.y + s * distance + s * height / 2.0;
  return {x - width / 2.0, y - height / 2.0, x + width / 2.0, y + height / 2.0};
}

double distance_to(const Box& box, double x, double y) {
  return std::hypot(x - std::clamp(x, box.left, box.right), y - std::clamp(y, box.top, box.bottom));
}

// Returns the length, in pixels, of the line from the request's point to its label that lies within a box.
double length_within(const LabelRequest& request, const Box& label, const Box& box) {
  constexpr int kSteps = 24;
  const double end_x = std::clamp(request.x, label.left, label.right);
  const double end_y = std::clamp(request.y, label.top, label.bottom);
  const bool apart = std::max(request.x, end_x) <= box.left || std::min(request.x, end_x) >= box.right ||
                     std::max(request.y, end_y) <= box.top || std::min(request.y, end_y) >= box.bottom;
  if (apart) return 0.0;
  int inside = 0;
  for (int i = 1; i < kSteps; ++i) {
    const double x = std::lerp(request.x, end_x, static_cast<double>(i) / kSteps);
    const double y = std::lerp(request.y, end_y, static_cast<double>(i) / kSteps);
    inside += x > box.left && x < box.right && y > box.top && y < box.bottom ? 1 : 0;
  }
  return std::hypot(end_x - request.x, end_y - request.y) * inside / kSteps;
}

// Returns whether the lines from two points to their labels cross.
bool lines_cross(const LabelRequest& a, const Box& label_a, const LabelRequest& b, const Box& label_b) {
  struct Spot {
    double x = 0.0;
    double y = 0.0;
  };
  const auto end = [](const LabelRequest& from, const Box& label) {
    return Spot{std::clamp(from.x, label.left, label.right), std::clamp(from.y, label.top, label.bottom)};
  };
  const auto side = [](Spot p, Spot q, Spot r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  };
  const Spot a0{a.x, a.y};
  const Spot b0{b.x, b.y};
  const Spot a1 = end(a, label_a);
  const Spot b1 = end(b, label_b);
  return side(a0, a1, b0) * side(a0, a1, b1) < 0.0 && side(b0, b1, a0) * side(b0, b1, a1) < 0.0;
}

// The labels placed so far, and the obstacles.
struct Surroundings {
  const std::vector<LabelRequest>& requests;
  const std::vector<Box>& obstacles;
  const Box& frame;
  const std::vector<std::optional<PlacedLabel>>& placed;  // indexed by request; absent if not yet placed
};

double covered_area(const Surroundings& around, std::size_t own, const Box& box) {
  double covered = 4.0 * (area(box) - overlap_area(box, around.frame));
  for (std::size_t i = 0; i < around.placed.size(); ++i) {
    if (i != own && around.placed[i]) covered += overlap_area(box, around.placed[i]->box);
  }
  for (const Box& obstacle : around.obstacles) covered += 2.0 * overlap_area(box, obstacle);
  return covered;
}

// The ambiguity of the label: from 0 to 1 for each other point to which it could seem to belong.
double ambiguity(const Surroundings& around, std::size_t own, const Box& box) {
  constexpr double kReach = 16.0;
  double sum = 0.0;
  const double mine = distance_to(box, around.requests[own].x, around.requests[own].y);
  for (std::size_t i = 0; i < around.requests.size(); ++i) {
    if (i == own) continue;
    const double others = distance_to(box, around.requests[i].x, around.requests[i].y);
    if (others < kReach) sum += others < mine + 4.0 ? 1.0 : 0.5 * (1.0 - others / kReach);
  }
  return sum;
}

double line_crossings(const Surroundings& around, std::size_t own, const Box& box) {
  constexpr double kRadius = 5.0;    // radius of a point
  constexpr double kCrossed = 15.0;  // cost of two crossing lines, as so many pixels over a label
  double crossings = 0.0;
  for (std::size_t i = 0; i < around.requests.size(); ++i) {
    const LabelRequest& other = around.requests[i];
    if (i == own) continue;
    crossings += length_within(around.requests[own], box,
                               {other.x - kRadius, other.y - kRadius, other.x + kRadius, other.y + kRadius});
  }
  for (std::size_t i = 0; i < around.placed.size(); ++i) {
    if (i == own || !around.placed[i]) continue;
    crossings += length_within(around.requests[own], box, around.placed[i]->box);
    crossings += length_within(around.requests[i], around.placed[i]->box, box);
    if (lines_cross(around.requests[own], box, around.requests[i], around.placed[i]->box))
      crossings += kCrossed;
  }
  return crossings;
}

// Once the cost reaches the limit, it need not be complete.
double cost(const Surroundings& around, std::size_t own, const Box& box, double distance, double limit) {
  constexpr double kAmbiguity = 400.0;  // cost in square pixels covered
  constexpr double kCrossing = 20.0;    // cost of each pixel over something
  constexpr double kFar = 0.5;          // cost of each pixel of distance
  double sum = kFar * distance;
  if (sum < limit) sum += covered_area(around, own, box);
  if (sum < limit) sum += kAmbiguity * ambiguity(around, own, box);
  if (sum < limit) sum += kCrossing * line_crossings(around, own, box);
  return sum;
}

struct Place {
  PlacedLabel label;
  double cost = std::numeric_limits<double>::infinity();
};

Place best_place(const Surroundings& around, std::size_t own, double font_pixels) {
  constexpr std::array kDistances = {9.0, 16.0, 28.0, 44.0, 64.0, 90.0, 120.0};
  constexpr int kDirections = 24;
  constexpr double kNear = 20.0;
  Place best;
  for (const double distance : kDistances) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kDirections;
      const Box box = box_at(around.requests[own], angle, distance, font_pixels);
      const double here = cost(around, own, box, distance, best.cost - 1e-9);
      if (here >= best.cost - 1e-9) continue;
      best = {{box, distance > kNear || ambiguity(around, own, box) > 0.0}, here};
    }
  }
  return best;
}

struct Placement {
  std::vector<std::optional<PlacedLabel>> labels;
  double cost = 0.0;
};

// Places the labels in this order, then again given the positions of the others, until none moves, at most a
// few times.
Placement placed_in_order(const std::vector<LabelRequest>& requests, const std::vector<Box>& obstacles,
                          const Box& frame, double font_pixels, const std::vector<std::size_t>& order) {
  constexpr int kRounds = 6;
  Placement placement{std::vector<std::optional<PlacedLabel>>(requests.size())};
  const Surroundings around{requests, obstacles, frame, placement.labels};
  for (int round = 0; round < kRounds; ++round) {
    bool moved = false;
    placement.cost = 0.0;
    for (const std::size_t i : order) {
      const Place place = best_place(around, i, font_pixels);
      moved = moved || placement.labels[i] != place.label;
      placement.labels[i] = place.label;
      placement.cost += place.cost;
    }
    if (!moved) break;
  }
  return placement;
}

// Returns the cheapest of the placements by the order of requests and of x, forwards and backwards.
Placement cheapest_placement(const std::vector<LabelRequest>& requests, const std::vector<Box>& obstacles,
                             const Box& frame, double font_pixels, std::size_t first) {
  std::vector<std::size_t> order(first);
  std::iota(order.begin(), order.end(), 0);
  std::vector<std::vector<std::size_t>> orders(4, order);
  std::stable_sort(orders[1].begin(), orders[1].end(),
                   [&](std::size_t a, std::size_t b) { return requests[a].x < requests[b].x; });
  orders[2].assign(orders[1].rbegin(), orders[1].rend());
  orders[3].assign(orders[0].rbegin(), orders[0].rend());
  Placement best;
  best.cost = std::numeric_limits<double>::infinity();
  for (const std::vector<std::size_t>& each : orders) {
    Placement placement = placed_in_order(requests, obstacles, frame, font_pixels, each);
    if (placement.cost < best.cost - 1e-9) best = std::move(placement);
  }
  return best;
}

}  // namespace

double overlap_area(const Box& a, const Box& b) {
  return area({std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
               std::min(a.bottom, b.bottom)});
}

std::vector<std::optional<PlacedLabel>> place_labels(const std::vector<LabelRequest>& requests,
                                                     const std::vector<Box>& obstacles, const Box& frame,
                                                     double font_pixels, std::size_t always) {
  const std::size_t first = std::min(always, requests.size());
  std::vector<std::optional<PlacedLabel>> labels =
      cheapest_placement(requests, obstacles, frame, font_pixels, first).labels;
  const Surroundings around{requests, obstacles, frame, labels};
  for (std::size_t i = first; i < requests.size(); ++i) {
    const Place place = best_place(around, i, font_pixels);
    if (place.cost < kHasRoom) labels[i] = place.label;
  }
  return labels;
}

}  // namespace penumbra::study
