#include "hlsl/string_interner.h"

#include <cstring>

namespace penumbra::hlsl {

namespace {

std::uint64_t mixed(std::uint64_t hash, std::uint64_t part) {
  constexpr std::uint64_t factor = 0x9E3779B97F4A7C15U;  // 2^64 / golden ratio: Knuth's multiplicative hash
  hash = (hash ^ part) * factor;
  return hash ^ (hash >> 32U);
}

// The hash takes eight characters at a time.
std::size_t hash_of(std::string_view word) {
  std::uint64_t hash = word.size();
  while (word.size() >= sizeof(std::uint64_t)) {
    std::uint64_t part = 0;
    std::memcpy(&part, word.data(), sizeof part);
    hash = mixed(hash, part);
    word.remove_prefix(sizeof part);
  }
  std::uint64_t rest = 0;
  for (const char c : word) rest = (rest << 8U) | static_cast<unsigned char>(c);
  return mixed(hash, rest);
}

}  // namespace

// Returns the slot of the string, or the free slot where it belongs.
std::size_t StringInterner::slot(std::string_view word, std::size_t hash) const {
  std::size_t at = hash & (slots_.size() - 1);
  while (slots_[at] != none) {
    const Known& known = words_[slots_[at]];
    if (known.hash == hash && known.spelling == word) break;
    at = (at + 1) & (slots_.size() - 1);
  }
  return at;
}

void StringInterner::grow() {
  constexpr std::size_t smallest = 4096;
  slots_.assign(slots_.empty() ? smallest : 2 * slots_.size(), none);
  for (std::size_t number = 0; number < words_.size(); ++number)
    slots_[slot(words_[number].spelling, words_[number].hash)] = static_cast<std::uint32_t>(number);
}

std::uint32_t StringInterner::add(std::string_view word) {
  if (2 * words_.size() >= slots_.size()) grow();
  const std::size_t hash = hash_of(word);
  std::uint32_t& number = slots_[slot(word, hash)];
  if (number == none) {
    number = static_cast<std::uint32_t>(words_.size());
    words_.push_back({word, hash});
  }
  return number;
}

std::uint32_t StringInterner::find(std::string_view word) const {
  return slots_.empty() ? none : slots_[slot(word, hash_of(word))];
}

}  // namespace penumbra::hlsl
