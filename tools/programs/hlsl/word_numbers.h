// Numbers for words: the same for those spelled alike, from 0 on in the order they are first met.
//
// A number, once given, stays: what is told of words by their number is told by position in a list.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace penumbra::hlsl {

class WordNumbers {
 public:
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  // `word` must stay where it is in memory as long as this does.
  std::uint32_t add(std::string_view word);
  std::uint32_t find(std::string_view word) const;  // none: never added
  std::size_t size() const { return words_.size(); }

 private:
  struct Known {
    std::string_view spelling;
    std::size_t hash;
  };

  std::size_t slot(std::string_view word, std::size_t hash) const;
  void grow();

  std::vector<Known> words_;
  std::vector<std::uint32_t> slots_;  // by hash, with open addressing; a power of two
};

}  // namespace penumbra::hlsl
