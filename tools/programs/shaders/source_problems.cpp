#include "shaders/source_problems.h"

#include <array>
#include <set>

#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/SPIRV/GLSL.std.450.h>

#include "hlsl/declarations.h"
#include "hlsl/tokens.h"
#include "shaders/debug_lines.h"
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

SourcePlace place_of(const hlsl::Token& token, const std::string& file) {
  return {token.file.empty() ? file : std::string(token.file), token.line};
}

// Returns the place of the last such identifier before `end`.
SourcePlace place_of(std::string_view word, const std::vector<hlsl::Token>& tokens, std::size_t end,
                     const std::string& file) {
  for (std::size_t at = end; at-- > 0;)
    if (tokens[at].spelling == word) return place_of(tokens[at], file);
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

// Finds the members of structs that are such matrices or arrays of them, by name.
class MatrixSearch {
 public:
  std::set<std::string> run(const SpirvModule& module) {
    spirv::for_each_instruction(module, [this](spirv::Words instruction) { visit(instruction); });
    return std::move(found_);
  }

  bool any() const { return !matrices_.empty(); }

 private:
  void visit(spirv::Words words) {
    if (words.size() < 3) return;
    switch (spirv::opcode(words)) {
      case spv::OpMemberName:
        if (words.size() > 3) names_[{words[1], words[2]}] = spirv::literal_text(words.subspan(3));
        break;
      case spv::OpTypeInt:
        integers_.insert(words[1]);
        break;
      case spv::OpTypeVector:
        if (integers_.contains(words[2])) vectors_.insert(words[1]);
        break;
      case spv::OpTypeMatrix:
        if (vectors_.contains(words[2])) matrices_.insert(words[1]);
        break;
      case spv::OpTypeArray:
      case spv::OpTypeRuntimeArray:
        if (matrices_.contains(words[2])) matrices_.insert(words[1]);
        break;
      case spv::OpTypeStruct:
        for (std::uint32_t member = 0; member + 2 < words.size(); ++member)
          if (matrices_.contains(words[member + 2])) found_.insert(names_[{words[1], member}]);
        break;
      default:
        break;
    }
  }

  std::map<std::pair<std::uint32_t, std::uint32_t>, std::string> names_;
  std::set<std::uint32_t> integers_;
  std::set<std::uint32_t> vectors_;
  std::set<std::uint32_t> matrices_;  // such matrices and arrays of them
  std::set<std::string> found_;
};

// Returns whether the type is "int4x4", "uint2x3" or similar.
bool is_integer_matrix(std::string_view type) {
  return (type.starts_with("int") || type.starts_with("uint")) && type.size() > 5 &&
         type[type.size() - 2] == 'x';
}

struct Declared {
  SourcePlace place;
  std::string rows = "int4 rows[4]";  // the array in its stead
};

// Finds the first `int4x4 name`.
Declared matrix_declaration(const std::string& name, const std::string& text, const std::string& file) {
  const std::vector<hlsl::Token> tokens = hlsl::lex(text);
  for (std::size_t at = 1; at < tokens.size(); ++at) {
    const std::string_view type = tokens[at - 1].spelling;
    if (tokens[at].spelling != name || !is_integer_matrix(type)) continue;
    const std::string scalar(type.substr(0, type.size() - 3));
    return {place_of(tokens[at], file), scalar + type.back() + " rows[" + type[type.size() - 3] + "]"};
  }
  return {};
}

struct Placed {
  std::size_t name = 0;      // its token
  std::string register_set;  // "t, space1"
  std::size_t first = 0;     // register
  std::size_t count = 1;
};

class RegisterReader {
 public:
  explicit RegisterReader(const std::vector<hlsl::Token>& tokens) : tokens_(tokens) {}

  std::vector<Placed> run() {
    for (const hlsl::Declaration& declaration : hlsl::read_declarations(tokens_)) {
      const bool buffer = declaration.kind == hlsl::Declaration::Kind::buffer;
      if (declaration.name == hlsl::Declaration::none) continue;
      if (!buffer && declaration.kind != hlsl::Declaration::Kind::variable) continue;
      read(declaration.name, buffer ? declaration.open : declaration.last);
    }
    return std::move(found_);
  }

 private:
  bool is(std::size_t at, std::string_view spelling) const {
    return at < tokens_.size() && tokens_[at].spelling == spelling;
  }

  static std::size_t number(std::string_view text, std::size_t otherwise) {
    std::size_t value = otherwise;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
  }

  // Reads `a : register(t0), b[2] : register(t1, space1)` from its first name to `end`.
  void read(std::size_t name, std::size_t end) {
    Placed placed{name, "", 0, 1};
    for (std::size_t at = name + 1; at < end; ++at) {
      if (is(at, "=") || is(at, "{")) return;
      if (is(at, ",")) placed = {at + 1, "", 0, 1};
      if (is(at, "[") && is(at + 2, "]")) placed.count *= number(tokens_[at + 1].spelling, 1);
      if (is(at, "register") && is(at + 1, "(") && at + 3 < end) at = read_register(at + 2, placed);
    }
  }

  std::size_t read_register(std::size_t at, Placed& placed) {
    const std::string_view word = tokens_[at].spelling;
    const bool of_resources =
        word.size() > 1 && std::string_view("tsub").find(word[0]) != std::string_view::npos;
    if (!of_resources || word.find_first_not_of("0123456789", 1) != std::string_view::npos) return at;
    placed.first = number(word.substr(1), 0);
    placed.register_set = word[0];
    if (is(at + 1, ",") && at + 2 < tokens_.size()) {
      placed.register_set.append(", ").append(tokens_[at + 2].spelling);
      at += 2;
    }
    found_.push_back(placed);
    return at + 1;
  }

  const std::vector<hlsl::Token>& tokens_;
  std::vector<Placed> found_;
};

bool overlap(const Placed& a, const Placed& b) {
  return a.register_set == b.register_set && a.first < b.first + b.count && b.first < a.first + a.count;
}

// Returns the names of a module's resources; for a block that of its type.
std::set<std::string> used_names(const SpirvModule& module) {
  std::map<std::uint32_t, std::string> names;
  std::map<std::uint32_t, std::uint32_t> pointed;  // by pointer type
  std::set<std::string> used;
  spirv::for_each_instruction(module, [&](spirv::Words words) {
    const spv::Op op = spirv::opcode(words);
    if (op == spv::OpName && words.size() > 2) names[words[1]] = spirv::literal_text(words.subspan(2));
    if (op == spv::OpTypePointer && words.size() > 3) pointed[words[1]] = words[3];
    if (op != spv::OpVariable || words.size() < 4) return;
    const bool resource = words[3] == spv::StorageClassUniformConstant ||
                          words[3] == spv::StorageClassUniform || words[3] == spv::StorageClassStorageBuffer;
    if (!resource) return;
    used.insert(names[words[2]]);
    used.insert(names[pointed[words[1]]]);
  });
  return used;
}

template <typename Condition>
std::vector<Target> targets_of(Condition condition) {
  std::vector<Target> targets;
  std::copy_if(std::begin(all_targets), std::end(all_targets), std::back_inserter(targets), condition);
  return targets;
}

// Finds the instructions of a kind, which have one message.
class KindSearch final : public ModuleSearch {
 public:
  using Kind = bool(spirv::Words instruction);
  KindSearch(const SpirvModule& module, Kind* is_of_kind, const char* message)
      : ModuleSearch(module), is_of_kind_(is_of_kind), message_(message) {}

 private:
  void visit(spirv::Words instruction) override {
    if (is_of_kind_(instruction)) report(message_);
  }

  Kind* is_of_kind_;
  const char* message_;
};

bool is_wave_operation(spirv::Words instruction) {
  const spv::Op op = spirv::opcode(instruction);
  return (op >= spv::OpGroupNonUniformElect && op <= spv::OpGroupNonUniformQuadSwap) ||
         (op >= spv::OpSubgroupBallotKHR && op <= spv::OpSubgroupReadInvocationKHR);
}

bool interpolates(spirv::Words instruction) {
  const std::uint32_t operation = spirv::operand(instruction, 4);
  return spirv::opcode(instruction) == spv::OpExtInst && operation >= GLSLstd450InterpolateAtCentroid &&
         operation <= GLSLstd450InterpolateAtOffset;
}

bool is_fine_or_coarse(spirv::Words instruction) {
  const spv::Op op = spirv::opcode(instruction);
  return op >= spv::OpDPdxFine && op <= spv::OpFwidthCoarse;
}

// Collects the names of the uniform buffers that are arrays.
class BufferArrays {
 public:
  std::set<std::string> run(const SpirvModule& module) {
    spirv::for_each_instruction(module, [this](spirv::Words instruction) { visit(instruction); });
    return std::move(found_);
  }

 private:
  void visit(spirv::Words words) {
    if (words.size() < 3) return;
    switch (spirv::opcode(words)) {
      case spv::OpName:
        names_[words[1]] = spirv::literal_text(words.subspan(2));
        break;
      case spv::OpDecorate:
        if (words[2] == spv::DecorationBlock) blocks_.insert(words[1]);
        break;
      case spv::OpTypeArray:
        if (blocks_.contains(words[2])) arrays_.insert(words[1]);
        break;
      case spv::OpTypePointer:
        if (words[2] == spv::StorageClassUniform && arrays_.contains(spirv::operand(words, 3)))
          pointers_.insert(words[1]);
        break;
      case spv::OpVariable:
        if (pointers_.contains(words[1])) found_.insert(names_[words[2]]);
        break;
      default:
        break;
    }
  }

  std::map<std::uint32_t, std::string> names_;
  std::set<std::uint32_t> blocks_;
  std::set<std::uint32_t> arrays_;
  std::set<std::uint32_t> pointers_;
  std::set<std::string> found_;
};

// Finds the first `> name[`.
SourcePlace array_declaration(const std::string& name, const std::string& text, const std::string& file) {
  const std::vector<hlsl::Token> tokens = hlsl::lex(text);
  for (std::size_t at = 1; at + 1 < tokens.size(); ++at)
    if (tokens[at].spelling == name && tokens[at - 1].spelling == ">" && tokens[at + 1].spelling == "[")
      return place_of(tokens[at], file);
  return {};
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

std::vector<hlsl::Diagnostic> integer_matrices(const SpirvModule& optimised, const std::string& text,
                                               const std::string& file) {
  MatrixSearch search;
  const std::set<std::string> members = search.run(optimised);
  std::vector<hlsl::Diagnostic> problems;
  for (const std::string& member : members) {
    const Declared declared = matrix_declaration(member, text, file);
    problems.push_back(error_at(
        declared.place, "'" + member +
                            "' is an integer matrix, which SPIR-V, GLSL and Metal cannot store in memory: "
                            "declare an array of its rows, such as " +
                            declared.rows));
  }
  if (problems.empty() && search.any())
    problems.push_back(
        error_at(SourcePlace{},
                 "an integer matrix is stored in memory, which SPIR-V, GLSL and Metal cannot do: "
                 "use an array of its rows, such as int4 rows[4]"));
  return problems;
}

std::vector<hlsl::Diagnostic> shared_registers(const SpirvModule& optimised, const std::string& text,
                                               const std::string& file) {
  if (text.find("register") == std::string::npos) return {};
  const std::vector<hlsl::Token> tokens = hlsl::lex(text);
  std::vector<Placed> placed = RegisterReader(tokens).run();
  const std::set<std::string> used = used_names(optimised);
  std::erase_if(placed,
                [&](const Placed& one) { return !used.contains(std::string(tokens[one.name].spelling)); });
  std::vector<hlsl::Diagnostic> problems;
  for (std::size_t later = 1; later < placed.size(); ++later) {
    const auto earlier = std::find_if(placed.begin(), placed.begin() + static_cast<std::ptrdiff_t>(later),
                                      [&](const Placed& one) { return overlap(one, placed[later]); });
    if (earlier == placed.begin() + static_cast<std::ptrdiff_t>(later)) continue;
    const hlsl::Token& name = tokens[placed[later].name];
    problems.push_back(
        error_at(place_of(name, file),
                 "'" + std::string(name.spelling) + "' and '" + std::string(tokens[earlier->name].spelling) +
                     "' are used and have the same register: leave the registers out, as Unity binds "
                     "by name, or give each its own"));
  }
  return problems;
}

std::vector<TargetProblem> target_problems(const SpirvModule& module, const std::string& text,
                                           const std::string& file) {
  std::vector<TargetProblem> problems;
  const auto find = [&](KindSearch::Kind* kind, const std::vector<Target>& targets, const char* message) {
    for (hlsl::Diagnostic& problem : KindSearch(module, kind, message).run())
      problems.push_back({targets, std::move(problem)});
  };
  const std::vector<Target> essl =
      targets_of([](Target target) { return target_language(target) == TargetLanguage::essl; });
  find(is_wave_operation,
       targets_of([](Target target) { return target_language(target) != TargetLanguage::msl; }),
       "wave functions need shader model 6.0, which neither Direct3D 11 nor OpenGL has: leave these APIs "
       "out with #pragma exclude_renderers, or call them only under Vulkan and Metal");
  find(interpolates, essl,
       "the EvaluateAttribute functions need OpenGL ES 3.2: leave gles3 out with "
       "#pragma exclude_renderers, or declare the input 'centroid' or 'sample'");
  find(is_fine_or_coarse, essl,
       "OpenGL ES has no fine and coarse derivatives: write ddx and ddy, or leave gles3 out with "
       "#pragma exclude_renderers");
  for (const std::string& name : BufferArrays().run(module))
    problems.push_back(
        {{Target::hlsl50},
         error_at(
             array_declaration(name, text, file),
             "'" + name +
                 "' is an array of constant buffers, which needs shader model 5.1, and Direct3D 11 has 5.0: "
                 "declare one cbuffer with an array in it")});
  return problems;
}

}  // namespace penumbra::shaders
