// Direct3D bytecode: the chunks of a DXBC container, and what they say of a program's cost.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace penumbra::fxc {

// Returns the contents of the first chunk with this name of four characters, "RDEF" for instance, or nothing
// if there is none or the container is damaged.
std::optional<std::string_view> chunk(std::string_view container, std::string_view name);

// The figures that Unity's inspector shows for Direct3D 11. They are static counts: a loop's body counts
// once.
struct BytecodeCost {
  std::uint32_t instructions = 0;             // declarations do not count
  std::uint32_t arithmetic = 0;               // those on floating-point numbers and integers
  std::uint32_t textures = 0;                 // sample, gather and load instructions
  std::uint32_t branches = 0;                 // dynamic flow control: if, loop, switch, break
  std::uint32_t temporaries = 0;              // registers of four components, indexable arrays included
  std::uint32_t group_shared = 0;             // bytes of groupshared memory
  std::array<std::uint32_t, 3> group_size{};  // threads; 0 for other stages than compute
};

// Returns nothing if the container has no code, or is damaged.
std::optional<BytecodeCost> bytecode_cost(std::string_view container);

}  // namespace penumbra::fxc
