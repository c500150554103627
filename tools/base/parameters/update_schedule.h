// The frames in which each cascade is drawn anew.
//
// A far cascade shows much of the world in large texels, so it may be drawn less often than a near one: its
// map is then older, by the motion of the sun and the casters since. Each cascade keeps the matrices with
// which it was drawn, and the camera must not leave what they show (fit_cascades' spheres do not turn with
// it).
//
// In the first frame and after a cut of the camera, all cascades are to be drawn, whatever is due.
//
// Periods are powers of two, and phases are chosen so that no frame has to draw more cascades than it must:
// with periods 1, 2, 4 and 4 every frame draws two of four.
#pragma once

#include <array>
#include <span>

namespace penumbra::parameters {

inline constexpr int kMostScheduled = 4;   // cascades
inline constexpr int kLongestPeriod = 64;  // frames

struct UpdateSchedule {
  int cascades = 0;
  std::array<int, kMostScheduled> periods{};  // frames from one update to the next
  std::array<int, kMostScheduled> phases{};   // frame of the first update, below the period

  // Frames count from 0 or from anywhere; a negative one counts too. Cascades: 0 to cascades - 1, else
  // std::out_of_range is thrown.
  bool is_due(int cascade, int frame) const { return age(cascade, frame) == 0; }
  int age(int cascade, int frame) const;  // frames since the last update, 0 when due
  int due(int frame) const;               // one bit for each cascade, the lowest for cascade 0
  int most_due() const;                   // cascades in the frame that draws most
  double mean_due() const;                // cascades per frame

  // Returns the degrees by which the sun has moved on, at most, when the cascade is drawn anew.
  double largest_age_degrees(int cascade, double degrees_per_frame) const;
};

// There are one to four periods, that of the nearest cascade first. Throws InputError for another number of
// them, and for one that is not a power of two from 1 to kLongestPeriod.
UpdateSchedule update_schedule(std::span<const int> periods);

}  // namespace penumbra::parameters
