#include "shaders/group_limits.h"

#include <glslang/MachineIndependent/localintermediate.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>

#include "hlsl/tokens.h"
#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {
namespace {

constexpr std::array<std::uint64_t, 3> kMostAlong{1024, 1024, 64};
constexpr std::uint64_t kMostThreads = 1024;
constexpr std::uint64_t kMostShared = 32768;  // bytes
constexpr std::uint64_t kTooLarge = std::uint64_t{1} << 40;

// The memory of a module's types and variables, in the order of their declarations.
class SharedMemory {
 public:
  explicit SharedMemory(const SpirvModule& module) {
    spirv::for_each_instruction(module, [this](spirv::Words instruction) { visit(instruction); });
  }
  std::uint64_t bytes() const { return bytes_; }

 private:
  std::uint64_t size(std::uint32_t id) const {
    const auto known = sizes_.find(id);
    return known == sizes_.end() ? 0 : known->second;
  }
  static std::uint64_t product(std::uint64_t a, std::uint64_t b) {
    return b != 0 && a > kTooLarge / b ? kTooLarge : a * b;
  }

  void visit(spirv::Words words) {
    if (words.size() < 2) return;
    const spv::Op op = spirv::opcode(words);
    if (op == spv::OpTypeInt || op == spv::OpTypeFloat)
      sizes_[words[1]] = words.size() > 2 ? words[2] / 8 : 4;
    if (op == spv::OpTypeBool) sizes_[words[1]] = 4;
    if (words.size() > 3 && (op == spv::OpTypeVector || op == spv::OpTypeMatrix))
      sizes_[words[1]] = product(size(words[2]), words[3]);
    if (words.size() > 3 && op == spv::OpConstant) constants_[words[2]] = words[3];
    if (words.size() > 3 && op == spv::OpTypeArray)
      sizes_[words[1]] = product(size(words[2]), constants_[words[3]]);
    if (op == spv::OpTypeStruct)
      for (const std::uint32_t member : words.subspan(2))
        sizes_[words[1]] = std::min(sizes_[words[1]] + size(member), kTooLarge);
    if (words.size() > 3 && op == spv::OpTypePointer) sizes_[words[1]] = size(words[3]);
    if (words.size() > 3 && op == spv::OpVariable && words[3] == spv::StorageClassWorkgroup)
      bytes_ = std::min(bytes_ + size(words[1]), kTooLarge);
  }

  std::map<std::uint32_t, std::uint64_t> sizes_;
  std::map<std::uint32_t, std::uint32_t> constants_;
  std::uint64_t bytes_ = 0;
};

// Returns the place of the last such identifier before `end`.
SourcePlace place_of(std::string_view word, const std::vector<hlsl::Token>& tokens, std::size_t end,
                     const std::string& file) {
  for (std::size_t at = end; at-- > 0;)
    if (tokens[at].spelling == word)
      return {tokens[at].file.empty() ? file : std::string(tokens[at].file), tokens[at].line};
  return {};
}

// Returns the index of the entry point's name where it is defined or declared last.
std::size_t entry_of(const std::vector<hlsl::Token>& tokens, std::string_view name) {
  for (std::size_t at = tokens.size(); at-- > 0;)
    if (tokens[at].spelling == name) return at;
  return tokens.size();
}

std::string thread_problem(const glslang::TIntermediate& tree) {
  std::uint64_t threads = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint64_t along = tree.getLocalSize(axis);
    const std::uint64_t most = kMostAlong[static_cast<std::size_t>(axis)];
    if (along == 0 || along > most)
      return "[numthreads] has " + std::to_string(along) + " threads along " + "xyz"[axis] +
             ", and Direct3D takes 1 to " + std::to_string(most);
    threads *= along;
  }
  if (threads <= kMostThreads) return {};
  return "[numthreads] makes groups of " + std::to_string(threads) + " threads, and Direct3D takes " +
         std::to_string(kMostThreads) + " at most";
}

}  // namespace

std::vector<hlsl::Diagnostic> beyond_group_limits(const glslang::TIntermediate& tree,
                                                  const SpirvModule& optimised, const std::string& text,
                                                  const std::string& file) {
  const std::string threads = thread_problem(tree);
  const std::uint64_t shared = SharedMemory(optimised).bytes();
  if (threads.empty() && shared <= kMostShared) return {};
  const std::vector<hlsl::Token> tokens = hlsl::lex(text);
  std::vector<hlsl::Diagnostic> problems;
  if (!threads.empty()) {
    const std::size_t entry = entry_of(tokens, tree.getEntryPointName());
    problems.push_back(error_at(place_of("numthreads", tokens, entry, file), threads));
  }
  if (shared > kMostShared)
    problems.push_back(error_at(place_of("groupshared", tokens, tokens.size(), file),
                                "the groupshared variables take " + std::to_string(shared) +
                                    " bytes, and Direct3D has " + std::to_string(kMostShared) +
                                    " for a group"));
  return problems;
}

}  // namespace penumbra::shaders
