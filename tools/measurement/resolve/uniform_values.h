// Uniforms by name, packed into whatever layout a shader's reflection asks for.
//
// Matrices act on column vectors (mul(M, v) in HLSL). Numbers are stored as the 32-bit words the shader
// reads: give integers to int uniforms and floats to float ones.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "platform/content_hash.h"
#include "shaders/reflect.h"

namespace penumbra::resolve {

class UniformValues {
 public:
  void set(const std::string& name, float value);
  void set(const std::string& name, int value);
  void set(const std::string& name, const glm::vec4& value);  // also fills float2 and float3 members
  void set(const std::string& name, std::span<const glm::vec4> array);
  void set(const std::string& name, std::span<const glm::dmat4> array);
  void set_integers(const std::string& name, std::array<int, 4> value);  // int2, int3, int4

  void merge(const UniformValues& other);  // other's values win

  bool contains(const std::string& name) const { return values_.count(name) != 0; }

  // The hash covers every name and word (platform/hashed_fields.h).
  friend void add_fields(platform::ContentHash& hash, const UniformValues& values);

  // Returns the bytes of one uniform block. Members without a value are zero; `unset` names those that the
  // shader reads.
  std::vector<std::byte> pack(const shaders::Resource& block, std::vector<std::string>& unset) const;

 private:
  using Words = std::array<std::uint32_t, 16>;
  struct Value {
    std::vector<Words> elements;  // up to 4 words used, or 16 of a matrix, column by column
    bool matrix = false;
  };
  std::map<std::string, Value> values_;
};

}  // namespace penumbra::resolve
