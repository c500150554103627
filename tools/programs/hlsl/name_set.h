// A small set of names that are known at compile time.
//
// Passes look up every identifier of a text, and nearly always it is not in the set: its length and first
// letter show that without a comparison.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra::hlsl {

template <std::size_t Size>
class NameSet {
 public:
  template <typename... Words>
  constexpr explicit NameSet(Words... words) : words_{words...} {
    for (const std::string_view word : words_) firsts_by_length_[word.size()] |= letter(word[0]);
  }

  constexpr bool contains(std::string_view word) const {
    if (word.empty() || word.size() > longest) return false;
    if ((firsts_by_length_[word.size()] & letter(word[0])) == 0) return false;
    for (const std::string_view known : words_)
      if (known == word) return true;
    return false;
  }

 private:
  static constexpr std::size_t longest = 31;  // a longer name does not compile

  // Upper and lower case, digits and punctuation share the 32 bits; false positives are few.
  static constexpr std::uint32_t letter(char c) {
    return std::uint32_t{1} << (static_cast<unsigned>(c) % 32U);
  }

  std::array<std::string_view, Size> words_;
  std::array<std::uint32_t, longest + 1> firsts_by_length_{};
};

template <typename... Words>
NameSet(Words...) -> NameSet<sizeof...(Words)>;

// Returns the names of a text with spaces between them.
inline std::vector<std::string> names_in(const char* spaced) {
  std::istringstream words(spaced);
  return {std::istream_iterator<std::string>(words), {}};
}

// Returns whether a value is one of a few.
template <typename Value>
constexpr bool is_one_of(Value value, std::initializer_list<Value> few) {
  return std::find(few.begin(), few.end(), value) != few.end();
}

}  // namespace penumbra::hlsl
