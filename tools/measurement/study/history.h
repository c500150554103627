// Temporal antialiasing of a technique's noise while nothing moves: each pixel's exponential mean over the
// frames.
//
//   history = (1 - share) history + share frame
//
// This is Karis, "High-Quality Temporal Supersampling", SIGGRAPH 2014, without its clamp to the colours of
// neighbours, which cuts the same noise off in every technique.
#pragma once

#include <vector>

namespace penumbra::study {

// Returns the number of frames that `results` results need. The first result comes when less than a hundredth
// of the mean is the first frame's. Each other one comes seven frames later, which meets every phase of noise
// that repeats after a power of two frames. `share` is that of the newest frame, above 0, up to 1.
int history_frames(double share, int results);

// Returns one image per result, from as many frames as history_frames() says.
std::vector<std::vector<float>> histories(const std::vector<std::vector<float>>& frames, double share,
                                          int results);

}  // namespace penumbra::study
