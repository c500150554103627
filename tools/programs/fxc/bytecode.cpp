#include "fxc/bytecode.h"

#include <cstring>
#include <vector>

namespace penumbra::fxc {

namespace {

std::uint32_t word_at(std::string_view bytes, std::size_t offset) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof word);
  return word;
}

std::vector<std::uint32_t> words_of(std::string_view bytes) {
  std::vector<std::uint32_t> words(bytes.size() / 4);
  std::memcpy(words.data(), bytes.data(), words.size() * 4);
  return words;
}

// A container begins with "DXBC", a checksum of 16 bytes, a version, its size and the number of chunks, whose
// offsets follow.
constexpr std::size_t kCountAt = 28;
constexpr std::size_t kOffsetsAt = 32;

// Instructions of shader models 4 and 5: bits 0 to 10 are the operation, 24 to 30 the length in words.
constexpr std::uint32_t kOperation = 0x7FFU;
constexpr std::uint32_t kCustomData = 53;  // the next word is its length
constexpr std::uint32_t kIndexableTemporaries = 105;
constexpr std::uint32_t kThreadGroup = 155;
constexpr std::uint32_t kSharedRaw = 159;
constexpr std::uint32_t kSharedStructured = 160;

// These are sample in its six forms, ld and ld_ms, and gather4 in its four.
bool reads_texture(std::uint32_t operation) {
  return (operation >= 69 && operation <= 74) || operation == 45 || operation == 46 || operation == 109 ||
         (operation >= 126 && operation <= 128);
}

void add_instruction(const std::vector<std::uint32_t>& code, std::size_t at, std::size_t length,
                     BytecodeCost& cost) {
  const auto operand = [&](std::size_t index) { return index < length ? code[at + index] : 0; };
  switch (code[at] & kOperation) {
    case kIndexableTemporaries:  // register, number of elements, components
      cost.temporaries += operand(2);
      break;
    case kThreadGroup:
      cost.group_size = {operand(1), operand(2), operand(3)};
      break;
    case kSharedRaw:  // an operand of two words, then bytes
      cost.group_shared += operand(3);
      break;
    case kSharedStructured:  // an operand of two words, then bytes of an element, and their number
      cost.group_shared += operand(3) * operand(4);
      break;
    default:
      cost.textures += reads_texture(code[at] & kOperation) ? 1 : 0;
  }
}

// Returns false for damaged code.
bool add_instructions(const std::vector<std::uint32_t>& code, BytecodeCost& cost) {
  for (std::size_t at = 2; at < code.size();) {  // behind the version and the length
    const bool custom = (code[at] & kOperation) == kCustomData;
    if (custom && at + 1 >= code.size()) return false;
    const std::size_t length = custom ? code[at + 1] : code[at] >> 24U & 0x7FU;
    if (length == 0 || length > code.size() - at) return false;
    add_instruction(code, at, length, cost);
    at += length;
  }
  return true;
}

}  // namespace

std::optional<std::string_view> chunk(std::string_view container, std::string_view name) {
  if (!container.starts_with("DXBC") || container.size() < kOffsetsAt) return std::nullopt;
  const std::size_t count = word_at(container, kCountAt);
  if (count > (container.size() - kOffsetsAt) / 4) return std::nullopt;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t offset = word_at(container, kOffsetsAt + 4 * i);
    if (offset > container.size() || container.size() - offset < 8) return std::nullopt;
    const std::size_t size = word_at(container, offset + 4);
    if (size > container.size() - offset - 8) return std::nullopt;
    if (container.substr(offset, 4) == name) return container.substr(offset + 8, size);
  }
  return std::nullopt;
}

std::optional<BytecodeCost> bytecode_cost(std::string_view container) {
  std::optional<std::string_view> code = chunk(container, "SHEX");
  if (!code) code = chunk(container, "SHDR");
  const std::optional<std::string_view> statistics = chunk(container, "STAT");
  // The order is that of D3D11_SHADER_DESC's counts, which leave gathers out of the texture instructions.
  constexpr std::size_t known = 9;
  if (!code || !statistics || statistics->size() < known * 4) return std::nullopt;
  const std::vector<std::uint32_t> counts = words_of(*statistics);
  BytecodeCost cost;
  cost.instructions = counts[0];
  cost.temporaries = counts[1];
  cost.arithmetic = counts[4] + counts[5] + counts[6];
  cost.branches = counts[8];
  if (!add_instructions(words_of(*code), cost)) return std::nullopt;
  return cost;
}

}  // namespace penumbra::fxc
