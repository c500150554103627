#include "resolve/uniform_values.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "platform/hashed_fields.h"

namespace penumbra::resolve {
namespace {

std::uint32_t word(float value) {
  return std::bit_cast<std::uint32_t>(value);
}
std::uint32_t word(int value) {
  return std::bit_cast<std::uint32_t>(value);
}

std::array<std::uint32_t, 16> words(const glm::vec4& v) {
  return {word(v.x), word(v.y), word(v.z), word(v.w)};
}

std::array<std::uint32_t, 16> words(const glm::dmat4& m) {
  std::array<std::uint32_t, 16> result{};
  auto next = result.begin();
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) *next++ = word(static_cast<float>(m[column][row]));
  }
  return result;
}

void store(std::vector<std::byte>& bytes, std::size_t offset, std::uint32_t value) {
  if (offset + sizeof(value) <= bytes.size()) std::memcpy(bytes.data() + offset, &value, sizeof(value));
}

// glslang exchanges the rows and columns of HLSL's matrices: a column_major one (HLSL's default and Unity's)
// comes out decorated RowMajor, and its memory holds the columns of mul(M, v) one after the other.
void store_matrix(std::vector<std::byte>& bytes, std::size_t offset, const shaders::UniformMember& member,
                  const std::array<std::uint32_t, 16>& columns) {
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 4; ++row) {
      const std::size_t major = member.row_major ? column : row;
      const std::size_t minor = member.row_major ? row : column;
      store(bytes, offset + major * member.matrix_stride + minor * 4, columns[4 * column + row]);
    }
  }
}

}  // namespace

void UniformValues::set(const std::string& name, float value) {
  values_[name] = {{{word(value)}}, false};
}
void UniformValues::set(const std::string& name, int value) {
  values_[name] = {{{word(value)}}, false};
}
void UniformValues::set(const std::string& name, const glm::vec4& value) {
  values_[name] = {{words(value)}, false};
}

void UniformValues::set(const std::string& name, std::span<const glm::vec4> array) {
  Value value;
  for (const glm::vec4& element : array) value.elements.push_back(words(element));
  values_[name] = std::move(value);
}

void UniformValues::set(const std::string& name, std::span<const glm::dmat4> array) {
  Value value;
  value.matrix = true;
  for (const glm::dmat4& element : array) value.elements.push_back(words(element));
  values_[name] = std::move(value);
}

void UniformValues::set_integers(const std::string& name, std::array<int, 4> value) {
  values_[name] = {{{word(value[0]), word(value[1]), word(value[2]), word(value[3])}}, false};
}

void UniformValues::merge(const UniformValues& other) {
  for (const auto& [name, value] : other.values_) values_[name] = value;
}

void add_fields(platform::ContentHash& hash, const UniformValues& values) {
  platform::add_all(hash, values.values_);
}

std::vector<std::byte> UniformValues::pack(const shaders::Resource& block,
                                           std::vector<std::string>& unset) const {
  std::vector<std::byte> bytes(block.size);
  for (const shaders::UniformMember& member : block.members) {
    const auto found = values_.find(member.name);
    if (found == values_.end()) {
      if (member.read) unset.push_back(member.name);
      continue;
    }
    const Value& value = found->second;
    const std::size_t length = std::max<std::size_t>(member.array_length, 1);
    for (std::size_t i = 0; i < std::min(length, value.elements.size()); ++i) {
      const std::size_t offset = member.offset + i * member.array_stride;
      if (value.matrix) {
        store_matrix(bytes, offset, member, value.elements[i]);
        continue;
      }
      const std::size_t room = member.size - i * member.array_stride;  // the last element may be shorter
      for (std::size_t k = 0; k < std::min<std::size_t>(4, room / 4); ++k) {
        store(bytes, offset + 4 * k, value.elements[i][k]);
      }
    }
  }
  return bytes;
}

}  // namespace penumbra::resolve
