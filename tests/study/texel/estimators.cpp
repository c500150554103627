#include "study/texel/estimators.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace penumbra::texel {
namespace {

// An edge with texels on its wrong side by as much is not used.
constexpr double kWorstMisfit = 0.25;
constexpr int kPoints = 64;

double length(double x, double y) {
  return std::sqrt(x * x + y * y);
}

template <class Weight>
double weighted(const Texels& texels, const Weight& weight) {
  if (texels.block() == 0 || texels.block() == 0xffff) return texels.block() == 0 ? 0.0 : 1.0;
  double covered = 0.0, all = 0.0;
  for (int y = -2; y < 2; ++y)
    for (int x = -2; x < 2; ++x) {
      const double own = weight(x, y);
      all += own;
      if (texels.covers(x, y)) covered += own;
    }
  return covered / all;
}

double blended(Point place, const Texels& texels, double kernel, const FittedEdge& edge, double of_edge) {
  const double trust = std::max(1.0 - edge.misfit / kWorstMisfit, 0.0);
  return trust == 1.0 ? of_edge : trust * of_edge + (1.0 - trust) * disc_kernel(place, texels, kernel);
}

double inside_of(const FittedEdge& edge, Point place) {
  return edge.normal.x * place.x + edge.normal.y * place.y - edge.offset;
}

// A side of a texel: from its lower left corner, `along` it, and `into` the texel.
struct Side {
  int x, y;
  int along_x, along_y, into_x, into_y;
};

// The border that the side belongs to, from its first to its last side, and where the line that takes its
// place begins and ends: half a side into the texels on this side of the border, half a side into those
// beyond, or on it.
struct Border {
  int first, last;  // sides before and after this one
  double begin, end;

  // The height of the line, at `at` sides from the beginning of this one.
  double height(double at) const {
    const double length = last + 1 - first, t = (at - first) / length;
    if (begin * end > 0.0) return begin * std::abs(1.0 - 2.0 * t);
    return begin + (end - begin) * t;
  }
};

Border border_of(const Texels& texels, const Side& side, int reach) {
  const auto inside = [&](int x, int y) { return x >= -reach && x < reach && y >= -reach && y < reach; };
  const bool own = texels.covers(side.x, side.y);
  const auto walk = [&](int step, int& sides) {
    for (sides = 0;; sides += step) {
      const int x = side.x + (sides + step) * side.along_x, y = side.y + (sides + step) * side.along_y;
      const int beyond_x = x - side.into_x, beyond_y = y - side.into_y;
      if (!inside(x, y) || !inside(beyond_x, beyond_y)) return 0.0;
      const bool here = texels.covers(x, y), there = texels.covers(beyond_x, beyond_y);
      if (here == own && there != own) continue;
      if (here != there) return 0.0;  // two corners meet
      return here == own ? -0.5 : 0.5;
    }
  };
  Border border{};
  border.begin = walk(-1, border.first);
  border.end = walk(1, border.last);
  return border;
}

}  // namespace

double bilinear(Point place, const Texels& texels) {
  const double x = place.x + 0.5, y = place.y + 0.5;
  const auto bit = [&](int i, int j) { return texels.covers(i, j) ? 1.0 : 0.0; };
  return (1.0 - y) * ((1.0 - x) * bit(-1, -1) + x * bit(0, -1)) +
         y * ((1.0 - x) * bit(-1, 0) + x * bit(0, 0));
}

double disc_kernel(Point place, const Texels& texels, double radius) {
  const std::array<double, 16> shares = shares_of_texels(place, radius);
  return weighted(texels, [&](int x, int y) { return shares[x + 2 + 4 * (y + 2)]; });
}

double shipped_kernel(Point place, const Texels& texels, double radius) {
  const double outermost = std::max(radius + 0.4, 0.75);
  return weighted(texels, [&](int x, int y) {
    return std::max(1.0 - length(x + 0.5 - place.x, y + 0.5 - place.y) / outermost, 0.0);
  });
}

FittedEdge fitted_edge(std::uint16_t block) {
  Point slope{0.0, 0.0};
  for (int i = 0; i < 16; ++i)
    if ((block >> i & 1) != 0) {
      slope.x += i % 4 - 1.5;
      slope.y += i / 4 - 1.5;
    }
  const double steepness = std::hypot(slope.x, slope.y);
  if (steepness == 0.0) return {};
  FittedEdge edge{true, {slope.x / steepness, slope.y / steepness}, 0.0, 0.0, 0.0};
  double clear = -std::numeric_limits<double>::infinity(), covered = -clear;
  for (int i = 0; i < 16; ++i) {
    const double at = edge.normal.x * (i % 4 - 1.5) + edge.normal.y * (i / 4 - 1.5);
    if ((block >> i & 1) != 0)
      covered = std::min(covered, at);
    else
      clear = std::max(clear, at);
  }
  edge.offset = 0.5 * (clear + covered);
  edge.room = std::max(0.5 * (covered - clear), 0.0);
  edge.misfit = std::max(clear - covered, 0.0);
  return edge;
}

double fit_of_edge(Point place, const Texels& texels, double radius, double kernel) {
  const FittedEdge edge = fitted_edge(texels.block());
  if (!edge.found) return disc_kernel(place, texels, kernel);
  return blended(place, texels, kernel, edge, covered_by_half_plane(inside_of(edge, place), radius));
}

double mean_fit_of_edge(Point place, const Texels& texels, double radius, double kernel) {
  const FittedEdge edge = fitted_edge(texels.block());
  if (!edge.found) return disc_kernel(place, texels, kernel);
  return blended(place, texels, kernel, edge,
                 mean_covered_by_half_plane(inside_of(edge, place), edge.room, radius));
}

bool covers_revectorised(const Texels& texels, Point point, int reach) {
  const int x = static_cast<int>(std::floor(point.x)), y = static_cast<int>(std::floor(point.y));
  const bool own = texels.covers(x, y);
  const double u = point.x - x, v = point.y - y;
  const struct {
    Side side;
    double along, into;
  } sides[] = {{{x, y, 1, 0, 0, 1}, u, v},
               {{x, y, 1, 0, 0, -1}, u, 1.0 - v},
               {{x, y, 0, 1, 1, 0}, v, u},
               {{x, y, 0, 1, -1, 0}, v, 1.0 - u}};
  for (const auto& [side, along, into] : sides) {
    if (texels.covers(x - side.into_x, y - side.into_y) == own || into >= 0.5) continue;
    if (border_of(texels, side, reach).height(along) > into) return !own;
  }
  return own;
}

double revectorised(Point place, const Texels& texels, double radius, int reach) {
  const std::uint16_t block = texels.block();
  if (block == 0 || block == 0xffff) return block == 0 ? 0.0 : 1.0;
  int covered = 0;
  for (int k = 0; k < kPoints; ++k) {  // the points are those of a Fibonacci disc
    static const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double away = radius * std::sqrt((k + 0.5) / kPoints);
    const Point point{place.x + away * std::cos(turn * k), place.y + away * std::sin(turn * k)};
    covered += covers_revectorised(texels, point, reach) ? 1 : 0;
  }
  return static_cast<double>(covered) / kPoints;
}

}  // namespace penumbra::texel
