#include "shaders/integer_matrices.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "hlsl/tokens.h"
#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

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
Declared declaration_of(const std::string& name, const std::string& text, const std::string& file) {
  const std::vector<hlsl::Token> tokens = hlsl::lex(text);
  for (std::size_t at = 1; at < tokens.size(); ++at) {
    const std::string_view type = tokens[at - 1].spelling;
    if (tokens[at].spelling != name || !is_integer_matrix(type)) continue;
    const std::string scalar(type.substr(0, type.size() - 3));
    return {{tokens[at].file.empty() ? file : std::string(tokens[at].file), tokens[at].line},
            scalar + type.back() + " rows[" + type[type.size() - 3] + "]"};
  }
  return {};
}

}  // namespace

std::vector<hlsl::Diagnostic> integer_matrices(const SpirvModule& optimised, const std::string& text,
                                               const std::string& file) {
  MatrixSearch search;
  const std::set<std::string> members = search.run(optimised);
  std::vector<hlsl::Diagnostic> problems;
  for (const std::string& member : members) {
    const Declared declared = declaration_of(member, text, file);
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

}  // namespace penumbra::shaders
