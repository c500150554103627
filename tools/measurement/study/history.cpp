#include "study/history.h"

#include <cmath>
#include <stdexcept>

namespace penumbra::study {
namespace {

constexpr double kForgotten = 0.01;
constexpr int kFramesBetween = 7;

// Returns the number of frames before the first result, and that of the result itself.
int first_frames(double share) {
  if (!(share > 0.0 && share <= 1.0)) throw std::invalid_argument("a share of a history is above 0, up to 1");
  if (share == 1.0) return 1;
  return 1 + static_cast<int>(std::ceil(std::log(kForgotten) / std::log1p(-share)));
}

int frames_between(double share) {
  return share == 1.0 ? 1 : kFramesBetween;
}

}  // namespace

int history_frames(double share, int results) {
  return first_frames(share) + frames_between(share) * (results - 1);
}

std::vector<std::vector<float>> histories(const std::vector<std::vector<float>>& frames, double share,
                                          int results) {
  if (results < 1 || static_cast<int>(frames.size()) != history_frames(share, results))
    throw std::invalid_argument("another number of frames than the history needs");
  const auto first = static_cast<std::size_t>(first_frames(share) - 1);
  const auto between = static_cast<std::size_t>(frames_between(share));
  std::vector<double> history(frames.front().begin(), frames.front().end());
  std::vector<std::vector<float>> images;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    if (frames[k].size() != history.size())
      throw std::invalid_argument("the frames of a history differ in size");
    for (std::size_t i = 0; i < history.size(); ++i)
      history[i] += share * (static_cast<double>(frames[k][i]) - history[i]);
    if (k >= first && (k - first) % between == 0) images.emplace_back(history.begin(), history.end());
  }
  return images;
}

}  // namespace penumbra::study
