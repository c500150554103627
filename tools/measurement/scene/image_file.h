// Pictures read from files: PNG, JPEG, TGA and BMP, by stb_image.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/material.h"
#include "scene/reading_process.h"

namespace penumbra::scene {

inline constexpr int kLargestImageSide = 8192;  // pixels

// Returns 8 bits a channel as stored. Grey becomes three equal channels, absent alpha 255. Throws InputError
// naming the file if it cannot be read, has none of these formats, is invalid, or is larger than the limit.
Texture read_image(const std::filesystem::path& file);

// Reads the same from memory; `name` is the name in messages.
Texture decode_image(std::span<const std::byte> bytes, const std::string& name);

// Images of heights: PNG with 16 bits a channel, and the headerless RAW files that Unity's terrains export.
inline constexpr int kLargestHeightImageSide =
    8193;  // samples: a power of two and one, as Unity's terrains have

struct HeightImage {
  int width = 0;  // samples
  int height = 0;
  std::vector<std::uint16_t>
      samples;  // rows from a picture's bottom, as in Unity's textures; of RAW as in the file
};

struct ImageSize {
  int width = 0;
  int height = 0;
};

// A PNG must have one channel of 16 bits; several are refused. RAW (.raw or .r16) has 16-bit numbers, the low
// byte first; without raw_size it must be a square. Throws InputError naming the file if it cannot be read,
// is no regular file, has neither form, has 8 bits (256 steps are too few for ground), is not a square where
// it must be, or is smaller than 2 x 2 or larger than the limit.
HeightImage read_height_image(const std::filesystem::path& file, std::optional<ImageSize> raw_size);

// Reads the same from memory. `name` is the name in messages; its extension tells the form.
HeightImage decode_height_image(std::span<const std::byte> bytes, const std::string& name,
                                std::optional<ImageSize> raw_size);

// Reads it in another process, as read_image_apart() does.
HeightImage read_height_image_apart(const std::filesystem::path& file, std::optional<ImageSize> raw_size,
                                    const ReadingProcess& process);

}  // namespace penumbra::scene
