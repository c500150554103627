#include "study/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace penumbra::study {
namespace {

// White of a D65 illuminant, as the matrix of sRGB gives it.
constexpr std::array<double, 9> kXyzOfRgb{
    10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0,
    2613072.0 / 12288897.0,  8788810.0 / 12288897.0, 887015.0 / 12288897.0,
    1425312.0 / 73733382.0,  8788810.0 / 73733382.0, 70074185.0 / 73733382.0};
constexpr std::array<double, 9> kRgbOfXyz{3.241003275, -1.537398934, -0.498615861, -0.969224334, 1.875930071,
                                          0.041554224, 0.055639423,  -0.204011202, 1.057148933};

glm::dvec3 times(const std::array<double, 9>& m, const glm::dvec3& v) {
  return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[3] * v.x + m[4] * v.y + m[5] * v.z,
          m[6] * v.x + m[7] * v.y + m[8] * v.z};
}

const glm::dvec3 kWhite = times(kXyzOfRgb, glm::dvec3(1.0));

double linear(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

// The linear opponent space YCxCz of the paper's section 4.1.
glm::dvec3 opponents_of(const glm::dvec3& rgb) {
  const glm::dvec3 ratio = times(kXyzOfRgb, rgb) / kWhite;
  return {116.0 * ratio.y - 16.0, 500.0 * (ratio.x - ratio.y), 200.0 * (ratio.y - ratio.z)};
}

glm::dvec3 rgb_of_opponents(const glm::dvec3& opponents) {
  const double y = (opponents.x + 16.0) / 116.0;
  return times(kRgbOfXyz, glm::dvec3(y + opponents.y / 500.0, y, y - opponents.z / 200.0) * kWhite);
}

double lab_curve(double ratio) {
  constexpr double kDelta = 6.0 / 29.0;
  return ratio > kDelta * kDelta * kDelta ? std::cbrt(ratio) : ratio / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
}

// The L*a*b* of a linear colour whose chroma shrinks with the lightness, as Hunt found.
glm::dvec3 hunt_lab_of(const glm::dvec3& rgb) {
  const glm::dvec3 ratio = times(kXyzOfRgb, rgb) / kWhite;
  const double y = lab_curve(ratio.y);
  const double lightness = 116.0 * y - 16.0;
  return {lightness, 0.01 * lightness * 500.0 * (lab_curve(ratio.x) - y),
          0.01 * lightness * 200.0 * (y - lab_curve(ratio.z))};
}

double hyab(const glm::dvec3& a, const glm::dvec3& b) {
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

using Plane = std::vector<double>;

struct Size {
  int width;
  int height;
};

using Kernel = std::vector<double>;  // of an odd number of weights, the middle one at the pixel

// Rows, then columns; beyond its edges a picture goes on as at them.
Plane convolved(const Plane& plane, const Size& size, const Kernel& along_x, const Kernel& along_y) {
  const int radius = static_cast<int>(along_x.size()) / 2;
  Plane rows(plane.size());
  Plane result(plane.size());
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      double sum = 0.0;
      for (int k = -radius; k <= radius; ++k)
        sum += along_x[static_cast<std::size_t>(k + radius)] *
               plane[static_cast<std::size_t>(y * size.width + std::clamp(x + k, 0, size.width - 1))];
      rows[static_cast<std::size_t>(y * size.width + x)] = sum;
    }
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      double sum = 0.0;
      for (int k = -radius; k <= radius; ++k)
        sum += along_y[static_cast<std::size_t>(k + radius)] *
               rows[static_cast<std::size_t>(std::clamp(y + k, 0, size.height - 1) * size.width + x)];
      result[static_cast<std::size_t>(y * size.width + x)] = sum;
    }
  return result;
}

double sum_of(const Kernel& kernel) {
  return std::accumulate(kernel.begin(), kernel.end(), 0.0);
}

// A term a sqrt(pi / b) exp(-pi^2 r^2 / b) of a contrast sensitivity, r in degrees.
struct SensitivityTerm {
  double a;
  double b;
};

constexpr SensitivityTerm kLuminance{1.0, 0.0047};
constexpr SensitivityTerm kRedGreen{1.0, 0.0053};
constexpr std::array<SensitivityTerm, 2> kBlueYellow{{{34.1, 0.04}, {13.5, 0.025}}};

Kernel gaussian(double b, double pixels_per_degree) {
  const int radius = static_cast<int>(std::ceil(
      3.0 * std::sqrt(kBlueYellow[0].b / (2.0 * std::numbers::pi * std::numbers::pi)) * pixels_per_degree));
  Kernel kernel;
  for (int k = -radius; k <= radius; ++k) {
    const double degrees = k / pixels_per_degree;
    kernel.push_back(std::exp(-std::numbers::pi * std::numbers::pi * degrees * degrees / b));
  }
  return kernel;
}

Plane seen_channel(const Plane& plane, const Size& size, std::span<const SensitivityTerm> terms,
                   double pixels_per_degree) {
  Plane sum(plane.size(), 0.0);
  double weight = 0.0;
  for (const SensitivityTerm& term : terms) {
    const Kernel kernel = gaussian(term.b, pixels_per_degree);
    const double scale = term.a * std::sqrt(std::numbers::pi / term.b);
    const Plane blurred = convolved(plane, size, kernel, kernel);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += scale * blurred[i];
    weight += scale * sum_of(kernel) * sum_of(kernel);
  }
  for (double& value : sum) value /= weight;
  return sum;
}

// Scales the positive weights to a sum of 1, and the negative ones to -1.
void balance(Kernel& kernel) {
  double above = 0.0;
  double below = 0.0;
  for (const double weight : kernel) (weight > 0.0 ? above : below) += weight;
  for (double& weight : kernel) weight /= weight > 0.0 ? above : -below;
}

// The strength of edges (first derivative of a Gaussian) or of points (second derivative), along both axes
// together.
std::vector<float> features(const Plane& luminance, const Size& size, bool of_edges,
                            double pixels_per_degree) {
  constexpr double kWidthDegrees = 0.082;
  const double deviation = 0.5 * kWidthDegrees * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3.0 * deviation));
  Kernel smooth;
  Kernel derived;
  for (int k = -radius; k <= radius; ++k) {
    const double along = k / deviation;
    smooth.push_back(std::exp(-0.5 * along * along));
    derived.push_back((of_edges ? -static_cast<double>(k) : along * along - 1.0) * smooth.back());
  }
  const double sum = sum_of(smooth);
  for (double& weight : smooth) weight /= sum;
  balance(derived);
  const Plane across = convolved(luminance, size, derived, smooth);
  const Plane down = convolved(luminance, size, smooth, derived);
  std::vector<float> strength(luminance.size());
  for (std::size_t i = 0; i < strength.size(); ++i)
    strength[i] = static_cast<float>(std::hypot(across[i], down[i]));
  return strength;
}

FlipReference::Seen seen_of(const FlipPicture& picture, double pixels_per_degree) {
  const Size size{picture.width, picture.height};
  const std::size_t pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  if (size.width <= 0 || size.height <= 0 || picture.colours.size() != pixels)
    throw std::invalid_argument("a picture for FLIP has another number of colours than pixels");
  std::array<Plane, 3> planes{Plane(pixels), Plane(pixels), Plane(pixels)};
  Plane luminance(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const glm::dvec3 encoded = glm::clamp(glm::dvec3(picture.colours[i]), 0.0, 1.0);
    const glm::dvec3 opponents = opponents_of({linear(encoded.x), linear(encoded.y), linear(encoded.z)});
    for (int channel = 0; channel < 3; ++channel)
      planes.at(static_cast<std::size_t>(channel))[i] = opponents[channel];
    luminance[i] = (opponents.x + 16.0) / 116.0;
  }
  const std::array<std::span<const SensitivityTerm>, 3> terms{
      std::span(&kLuminance, 1), std::span(&kRedGreen, 1), std::span(kBlueYellow)};
  for (std::size_t channel = 0; channel < 3; ++channel)
    planes.at(channel) = seen_channel(planes.at(channel), size, terms.at(channel), pixels_per_degree);
  FlipReference::Seen seen;
  seen.lab.reserve(pixels);
  for (std::size_t i = 0; i < pixels; ++i)
    seen.lab.emplace_back(
        hunt_lab_of(glm::clamp(rgb_of_opponents({planes[0][i], planes[1][i], planes[2][i]}), 0.0, 1.0)));
  seen.edges = features(luminance, size, true, pixels_per_degree);
  seen.points = features(luminance, size, false, pixels_per_degree);
  return seen;
}

// Maps a distance of colours to 0 .. 1: those up to a share of the largest one take most of the range.
double redistributed(double distance) {
  constexpr double kExponent = 0.7;
  constexpr double kShare = 0.4;
  constexpr double kRange = 0.95;
  static const double largest =
      std::pow(hyab(hunt_lab_of({0.0, 1.0, 0.0}), hunt_lab_of({0.0, 0.0, 1.0})), kExponent);
  const double raised = std::pow(distance, kExponent);
  const double knee = kShare * largest;
  if (raised < knee) return kRange / knee * raised;
  return kRange + (raised - knee) / (largest - knee) * (1.0 - kRange);
}

}  // namespace

FlipReference::FlipReference(const FlipPicture& reference, double pixels_per_degree)
    : width_(reference.width),
      height_(reference.height),
      pixels_per_degree_(pixels_per_degree),
      seen_(seen_of(reference, pixels_per_degree)) {}

std::vector<float> FlipReference::differences(const FlipPicture& test) const {
  if (test.width != width_ || test.height != height_)
    throw std::invalid_argument("FLIP compares pictures of one size");
  const Seen seen = seen_of(test, pixels_per_degree_);
  std::vector<float> differences(seen.lab.size());
  for (std::size_t i = 0; i < differences.size(); ++i) {
    const double colour = redistributed(hyab(glm::dvec3(seen_.lab[i]), glm::dvec3(seen.lab[i])));
    const double feature =
        std::max(std::abs(seen_.edges[i] - seen.edges[i]), std::abs(seen_.points[i] - seen.points[i]));
    const double raised = std::min(std::sqrt(feature / std::numbers::sqrt2), 1.0);
    differences[i] = static_cast<float>(std::clamp(std::pow(colour, 1.0 - raised), 0.0, 1.0));
  }
  return differences;
}

double FlipReference::mean_difference(const FlipPicture& test) const {
  const std::vector<float> all = differences(test);
  return std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
}

}  // namespace penumbra::study
