// Pictures read from files: PNG, JPEG, TGA and BMP, by stb_image.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "scene/material.h"

namespace penumbra::scene {

inline constexpr int kLargestImageSide = 8192;  // pixels

// Returns 8 bits a channel as stored. Grey becomes three equal channels, absent alpha 255. Throws InputError
// naming the file if it cannot be read, has none of these formats, is invalid, or is larger than the limit.
Texture read_image(const std::filesystem::path& file);

// Reads the same from memory; `name` is the name in messages.
Texture decode_image(std::span<const std::byte> bytes, const std::string& name);

}  // namespace penumbra::scene
