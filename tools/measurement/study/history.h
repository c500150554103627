// What temporal antialiasing makes of a technique's noise while nothing moves: each pixel's exponential mean
// over the frames.
//
//     history = (1 - share) history + share frame
//
// as in Karis, "High-Quality Temporal Supersampling", SIGGRAPH 2014, without its clamp to the colours of
// neighbours, which cuts the same noise off in every technique.
#pragma once

#include <vector>

namespace penumbra::study {

// How many frames `results` results need: the first when less than a hundredth of the mean is that of the
// frame it began with, each other one seven frames later, which meets every phase of noise that repeats after
// a power of two frames. share: of the newest frame, above 0, up to 1.
int history_frames(double share, int results);

// One image per result, of so many frames as history_frames() says.
std::vector<std::vector<float>> histories(const std::vector<std::vector<float>>& frames, double share,
                                          int results);

}  // namespace penumbra::study
