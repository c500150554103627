// Inputs to try functions on: the numbers that break shaders, and seeded random ones.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

namespace penumbra::shader_library_tests {

constexpr int kRandomCases = 20000;

// NaN of both signs, quiet and signalling, with several payloads; infinities; the ends of the range.
inline std::vector<float> special_floats() {
  std::vector<float> values;
  for (const std::uint32_t bits : {0x7FC00000u, 0xFFC00000u, 0x7F800001u, 0xFF800001u, 0x7FFFFFFFu,
                                   0xFFFFFFFFu, 0x7FA5A5A5u, 0x7F800000u, 0xFF800000u, 0x7F7FFFFFu,
                                   0xFF7FFFFFu, 0x00800000u, 0x80800000u, 0x80000000u, 0x00000000u}) {
    values.push_back(std::bit_cast<float>(bits));
  }
  for (const float value : {1.0f, 0.5f, 2.0f, 1e5f, 1e-5f, 1e10f, 1e-10f, 1e20f, 1e-20f}) {
    values.push_back(value);
    values.push_back(-value);
    values.push_back(std::nextafter(value, 0.0f));
    values.push_back(std::nextafter(value, 1e30f));
  }
  return values;
}

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  float between(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine_); }
  // A number of either sign, whose magnitude is spread evenly over the exponents between the two powers of
  // ten.
  float magnitude(float low_power, float high_power) {
    const float size = std::pow(10.0f, between(low_power, high_power));
    return (engine_() & 1u) != 0 ? size : -size;
  }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  float any_bits() { return std::bit_cast<float>(static_cast<std::uint32_t>(engine_())); }

 private:
  std::mt19937 engine_;
};

using Case = std::vector<float>;  // the inputs of one case

// The cases that `of_case(random)` or `of_case(random, number)` makes, one after the other.
template <typename OfCase>
std::vector<float> random_cases(std::uint32_t seed, const OfCase& of_case, int count = kRandomCases) {
  Random random(seed);
  std::vector<float> inputs;
  for (int i = 0; i < count; ++i) {
    Case one;
    if constexpr (std::is_invocable_v<OfCase, Random&, int>)
      one = of_case(random, i);
    else
      one = of_case(random);
    inputs.insert(inputs.end(), one.begin(), one.end());
  }
  return inputs;
}

// As many of special_floats(), drawn at random.
inline std::vector<float> random_special_floats(Random& random, std::size_t count) {
  const std::vector<float> all = special_floats();
  std::vector<float> drawn;
  for (std::size_t i = 0; i < count; ++i)
    drawn.push_back(all[static_cast<std::size_t>(random.integer(0, static_cast<int>(all.size()) - 1))]);
  return drawn;
}

}  // namespace penumbra::shader_library_tests
