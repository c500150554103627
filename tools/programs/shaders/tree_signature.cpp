#include "shaders/tree_signature.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "spirv/words.h"

namespace penumbra::shaders {
namespace {

std::string capitals(std::string semantic) {
  std::transform(semantic.begin(), semantic.end(), semantic.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return semantic;
}

std::string numbered(std::string semantic) {
  const bool has_number = !semantic.empty() && std::isdigit(static_cast<unsigned char>(semantic.back())) != 0;
  return has_number || semantic.starts_with("SV_") ? semantic : semantic + "0";
}

// glslang flattens the arrays in structs to variables "input.uv[1]" with the semantic of the first.
std::string semantic_at(const std::string& first, const std::string& variable) {
  const std::size_t open = variable.rfind('[');
  if (open == std::string::npos || !variable.ends_with(']')) return first;
  const std::size_t digits = first.find_last_not_of("0123456789") + 1;
  int index = 0, place = 0;
  std::from_chars(first.data() + digits, first.data() + first.size(), index);
  std::from_chars(variable.data() + open + 1, variable.data() + variable.size(), place);
  return first.substr(0, digits) + std::to_string(index + place);
}

std::string_view name_of(const SignatureElement& element) {
  return std::string_view(element.semantic).substr(0, element.semantic.find_last_not_of("0123456789") + 1);
}

SignatureType signature_type(glslang::TBasicType type) {
  switch (type) {
    case glslang::EbtFloat:
    case glslang::EbtFloat16:
      return SignatureType::floating;
    case glslang::EbtInt:
    case glslang::EbtInt16:
      return SignatureType::signed_integer;
    case glslang::EbtUint:
    case glslang::EbtUint16:
      return SignatureType::unsigned_integer;
    default:
      return SignatureType::other;
  }
}

// Returns the locations of the input variables that an instruction of a function refers to.
std::unordered_set<std::uint32_t> read_locations(std::span<const std::uint32_t> spirv) {
  std::unordered_map<std::uint32_t, std::uint32_t> located;  // ids
  std::unordered_set<std::uint32_t> inputs, read;
  spirv::for_each_instruction(spirv, [&](spirv::Words instruction) {
    const auto use = [&](std::uint32_t id) {
      const auto found = located.find(id);
      if (inputs.count(id) != 0 && found != located.end()) read.insert(found->second);
    };
    switch (spirv::opcode(instruction)) {
      case spv::OpDecorate:
        if (spirv::operand(instruction, 2) == spv::DecorationLocation)
          located[spirv::operand(instruction, 1)] = spirv::operand(instruction, 3);
        break;
      case spv::OpVariable:
        if (spirv::operand(instruction, 3) == spv::StorageClassInput)
          inputs.insert(spirv::operand(instruction, 2));
        break;
      case spv::OpLoad:
      case spv::OpAccessChain:
      case spv::OpInBoundsAccessChain:
        use(spirv::operand(instruction, 3));
        break;
      case spv::OpCopyMemory:
        use(spirv::operand(instruction, 2));
        break;
      case spv::OpExtInst:  // interpolateAtOffset() and others
      case spv::OpFunctionCall:
        for (std::size_t i = 4; i < instruction.size(); ++i) use(instruction[i]);
        break;
      default:
        break;
    }
  });
  return read;
}

// Control points and the vertices of a primitive are an array around each of their values.
bool is_of_vertices(const glslang::TIntermediate& tree, const glslang::TQualifier& qualifier) {
  if (qualifier.patch) return false;
  const bool input = qualifier.storage == glslang::EvqVaryingIn;
  switch (tree.getStage()) {
    case EShLangTessControl:
      return true;
    case EShLangTessEvaluation:
    case EShLangGeometry:
      return input;
    default:
      return false;
  }
}

void add_shape(const glslang::TType& type, bool of_vertices, SignatureElement& element) {
  element.type = signature_type(type.getBasicType());
  const int dimensions = type.isArray() ? type.getArraySizes()->getNumDims() : 0;
  for (int i = of_vertices ? 1 : 0; i < dimensions; ++i)
    element.count *= std::max(1, static_cast<int>(type.getArraySizes()->getDimSize(i)));
  if (type.isMatrix())
    element.count *= type.getMatrixCols();
  else
    element.components = std::max(1, type.getVectorSize());
}

}  // namespace

Signature tree_signature(const glslang::TIntermediate& tree, std::span<const std::uint32_t> spirv) {
  const std::unordered_set<std::uint32_t> read = read_locations(spirv);
  Signature signature;
  for (const TIntermNode* node : tree.findLinkerObjects()->getSequence()) {
    const glslang::TIntermSymbol* symbol = const_cast<TIntermNode*>(node)->getAsSymbolNode();
    if (symbol == nullptr) continue;
    const glslang::TQualifier& qualifier = symbol->getQualifier();
    if (qualifier.storage != glslang::EvqVaryingIn && qualifier.storage != glslang::EvqVaryingOut) continue;
    if (qualifier.semanticName == nullptr) continue;
    SignatureElement element;
    element.semantic = semantic_at(numbered(capitals(qualifier.semanticName)), symbol->getName().c_str());
    element.output = qualifier.storage == glslang::EvqVaryingOut;
    element.per_patch = qualifier.patch;
    if (qualifier.hasLocation()) element.location = static_cast<int>(qualifier.layoutLocation);
    add_shape(symbol->getType(), is_of_vertices(tree, qualifier), element);
    element.read = !element.output && element.location >= 0 &&
                   read.count(static_cast<std::uint32_t>(element.location)) != 0;
    signature.push_back(std::move(element));
  }
  return signature;
}

void add_places(const std::vector<preparation::SemanticPlace>& places, Signature& signature) {
  for (const preparation::SemanticPlace& place : places) {
    const std::string semantic = numbered(capitals(place.semantic));
    for (SignatureElement& element : signature)
      if (element.output == place.output && element.semantic == semantic) {
        element.written = place.semantic;
        element.file = place.file;
        element.line = place.line;
      }
  }
  // The source names the first of a flattened array.
  for (std::size_t i = 1; i < signature.size(); ++i) {
    const SignatureElement& before = signature[i - 1];
    SignatureElement& element = signature[i];
    if (element.line > 0 || element.output != before.output || name_of(element) != name_of(before)) continue;
    element.written = before.written;
    element.file = before.file;
    element.line = before.line;
  }
}

}  // namespace penumbra::shaders
