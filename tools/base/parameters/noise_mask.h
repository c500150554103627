// A spatio-temporal blue-noise mask: noise whose neighbours differ, in a frame and from one frame to the
// next.
//
// Void and cluster (Ulichney, "The Void-and-Cluster Method for Dither Array Generation", 1993) over a volume
// of slices, one for each frame, with the energy of Wolfe, Morrical, Akenine-Moller and Ramamoorthi,
// "Spatiotemporal Blue Noise Masks" (2022): points repel each other within a slice by a Gaussian of their
// distance, and at one pixel by a Gaussian of the time between them, each with a standard deviation of 1.9
// texels or slices; elsewhere they do not. The volume is toroidal: it repeats without a seam in both
// directions and in time. Ranks are of the slice: each value is used once in every slice, as Wolfe's are only
// nearly.
//
// Energies are whole numbers, so every machine generates the same bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace penumbra::parameters {

inline constexpr int kNoiseMaskSide = 64;
inline constexpr int kNoiseMaskSlices = 16;

struct NoiseMask {
  int side = 0;    // texels of a slice each way
  int slices = 0;  // frames
  // The ranks are stored row by row, slice by slice: each of 0 .. side * side - 1 occurs once in every slice.
  std::vector<std::uint16_t> ranks;

  std::uint16_t rank(int x, int y, int slice) const {
    return ranks[(static_cast<std::size_t>(slice) * static_cast<std::size_t>(side) +
                  static_cast<std::size_t>(y)) *
                     static_cast<std::size_t>(side) +
                 static_cast<std::size_t>(x)];
  }
  // Returns the rank of the texel in 0 .. 255: each value is as frequent as every other where side * side is
  // a multiple of 256.
  std::uint8_t byte(int x, int y, int slice) const {
    return static_cast<std::uint8_t>(rank(x, y, slice) * 256 / (side * side));
  }
};

// `side` is 8 .. 256 and `slices` 1 .. 64; otherwise throws std::invalid_argument. `between` is called every
// few milliseconds and may throw to end the work. 64 x 64 x 16 take seconds.
NoiseMask generate_noise_mask(int side = kNoiseMaskSide, int slices = kNoiseMaskSlices,
                              const std::function<void()>& between = {});

// The mean power of frequencies, divided by that of white noise, whose power is 1 at every frequency.
struct NoiseSpectrum {
  std::vector<double> spatial;   // a slice's, in rings of 1/8 of the highest frequency along an axis
  std::vector<double> temporal;  // a pixel's over the slices: 1 .. slices / 2 periods
};

// `values` are in the order of NoiseMask::ranks, in any unit.
NoiseSpectrum spectrum_of(const std::vector<double>& values, int side, int slices);
NoiseSpectrum spectrum_of(const NoiseMask& mask);
// Returns the spectrum of the noise that shaders have without a mask (ShaderLibrary/Core/Noise.hlsl), over as
// many pixels and frames.
NoiseSpectrum gradient_noise_spectrum(int side, int slices);

std::string noise_mask_table(const NoiseMask& mask);
std::string noise_mask_json(const NoiseMask& mask);

}  // namespace penumbra::parameters
