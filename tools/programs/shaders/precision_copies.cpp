#include "shaders/precision_copies.h"

#include <algorithm>
#include <unordered_set>
#include <vector>

#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

bool is_word_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool is_copy(std::string_view word) {
  return word.substr(0, 8) == "mp_copy_" || word.substr(0, 8) == "hp_copy_";
}

// Returns whether ` = value` follows, and not ` == value`.
bool is_set_at(std::string_view text, std::size_t at) {
  return text.substr(at, 3) == " = ";
}

bool is_relaxed_precision(spirv::Words words) {
  const spv::Op op = spirv::opcode(words);
  return (op == spv::OpDecorate && words.size() == 3 && words[2] == spv::DecorationRelaxedPrecision) ||
         (op == spv::OpMemberDecorate && words.size() == 4 && words[3] == spv::DecorationRelaxedPrecision);
}

}  // namespace

bool reads_lost_copy(std::string_view essl) {
  std::unordered_set<std::string_view> known;
  std::vector<std::vector<std::string_view>> blocks(1);  // the declarations of each open block
  for (std::size_t at = 0; at < essl.size();) {
    if (essl[at] == '{') blocks.emplace_back();
    if (essl[at] == '}' && blocks.size() > 1) {
      for (const std::string_view name : blocks.back()) known.erase(name);
      blocks.pop_back();
    }
    if (!is_word_character(essl[at])) {
      ++at;
      continue;
    }
    std::size_t end = at;
    while (end < essl.size() && is_word_character(essl[end])) ++end;
    const std::string_view word = essl.substr(at, end - at);
    if (is_copy(word)) {
      if (is_set_at(essl, end) && known.insert(word).second) blocks.back().push_back(word);
      if (known.count(word) == 0) return true;
    }
    at = end;
  }
  return false;
}

SpirvModule without_relaxed_precision(const SpirvModule& module) {
  return spirv::with_instructions(module, [](spirv::Words words) { return !is_relaxed_precision(words); });
}

}  // namespace penumbra::shaders
