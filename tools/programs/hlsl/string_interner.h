// Interns strings: equal strings get the same number, from 0 on in the order they are first added.
//
// A number never changes, so it can index a list of properties of each string.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace penumbra::hlsl {

class StringInterner {
 public:
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  // `word` must stay at its address as long as this object lives.
  std::uint32_t add(std::string_view word);
  std::uint32_t find(std::string_view word) const;  // `none` if never added
  std::size_t size() const { return words_.size(); }

 private:
  struct Known {
    std::string_view spelling;
    std::size_t hash;
  };

  std::size_t slot(std::string_view word, std::size_t hash) const;
  void grow();

  std::vector<Known> words_;
  std::vector<std::uint32_t> slots_;  // indexed by hash, with open addressing; the size is a power of two
};

}  // namespace penumbra::hlsl
