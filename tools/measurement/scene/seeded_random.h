// Random numbers that are the same on every machine: the raw output of the standard's mt19937, which the
// standard defines exactly, without its distributions, which it does not.
#pragma once

#include <cstdint>
#include <random>

namespace penumbra::scene {

class SeededRandom {
 public:
  explicit SeededRandom(std::uint32_t seed) : engine_(seed) {}

  // Returns a number in [low, high), in steps of 2^-32 of the range.
  double between(double low, double high) {
    constexpr double range = 4294967296.0;  // 2^32
    return low + (high - low) * (static_cast<double>(engine_()) / range);
  }

 private:
  std::mt19937 engine_;
};

}  // namespace penumbra::scene
