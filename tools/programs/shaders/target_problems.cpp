#include "shaders/target_problems.h"

#include <map>
#include <set>

#include <glslang/SPIRV/GLSL.std.450.h>

#include "hlsl/name_set.h"
#include "hlsl/tokens.h"
#include "shaders/debug_lines.h"
#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

SourcePlace place_of(const hlsl::Token& token, const std::string& file) {
  return {token.file.empty() ? file : std::string(token.file), token.line};
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

bool gathers_at_a_variable_offset(spirv::Words instruction) {
  const spv::Op op = spirv::opcode(instruction);
  return (op == spv::OpImageGather || op == spv::OpImageDrefGather) &&
         (spirv::operand(instruction, 6) & spv::ImageOperandsOffsetMask) != 0;
}

// Finds the requests for the size of a buffer: StructuredBuffer and ByteAddressBuffer are arrays, Buffer is
// an image.
class BufferSizeSearch final : public ModuleSearch {
 public:
  using ModuleSearch::ModuleSearch;

 private:
  void visit(spirv::Words instruction) override {
    const spv::Op op = spirv::opcode(instruction);
    if (op == spv::OpTypeImage && spirv::operand(instruction, 3) == spv::DimBuffer)
      buffer_types_.insert(spirv::operand(instruction, 1));
    if (op == spv::OpLoad && buffer_types_.contains(spirv::operand(instruction, 1)))
      buffers_.insert(spirv::operand(instruction, 2));
    if (op == spv::OpArrayLength ||
        (op == spv::OpImageQuerySize && buffers_.contains(spirv::operand(instruction, 3))))
      report(
          "Metal has no GetDimensions of a buffer: pass its size in a constant, or leave metal out with "
          "#pragma exclude_renderers");
  }

  std::set<std::uint32_t> buffer_types_;
  std::set<std::uint32_t> buffers_;  // loaded
};

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

// The images that a shader writes and OpenGL ES 3.1 does not have (OpenGL ES Shading Language 3.10, 4.4.7).
class WrittenImages {
 public:
  struct Found {
    std::string name;
    bool has_format = false;  // ES has its format, but not for images that are read as well
  };

  std::vector<Found> run(const SpirvModule& module) {
    spirv::for_each_instruction(module, [this](spirv::Words instruction) { visit(instruction); });
    std::vector<Found> found;
    for (const auto& [variable, format] : formats_) {
      const bool has_format = is_in_es(format);
      const bool both = read_.contains(variable) && written_.contains(variable);
      if (!has_format || (both && !has_one_component(format)))
        found.push_back({names_[variable], has_format});
    }
    return found;
  }

 private:
  void visit(spirv::Words words) {
    switch (spirv::opcode(words)) {
      case spv::OpName:
        names_[words[1]] = spirv::literal_text(words.subspan(2));
        break;
      case spv::OpTypeImage:
        if (words[7] == 2 && words[3] != spv::DimBuffer)
          types_[words[1]] = static_cast<spv::ImageFormat>(words[8]);
        break;
      case spv::OpTypePointer:
        if (const auto type = types_.find(words[3]); type != types_.end()) types_[words[1]] = type->second;
        break;
      case spv::OpVariable:
        if (const auto type = types_.find(words[1]); type != types_.end()) formats_[words[2]] = type->second;
        break;
      case spv::OpLoad:
        if (formats_.contains(words[3])) variables_[words[2]] = words[3];
        break;
      case spv::OpImageRead:
        read_.insert(variables_[words[3]]);
        break;
      case spv::OpImageWrite:
        written_.insert(variables_[words[1]]);
        break;
      default:
        break;
    }
  }

  static bool has_one_component(spv::ImageFormat format) {
    return hlsl::is_one_of(format, {spv::ImageFormatR32f, spv::ImageFormatR32i, spv::ImageFormatR32ui});
  }

  static bool is_in_es(spv::ImageFormat format) {
    return has_one_component(format) ||
           hlsl::is_one_of(format,
                           {spv::ImageFormatRgba32f, spv::ImageFormatRgba16f, spv::ImageFormatRgba8,
                            spv::ImageFormatRgba8Snorm, spv::ImageFormatRgba32i, spv::ImageFormatRgba16i,
                            spv::ImageFormatRgba8i, spv::ImageFormatRgba32ui, spv::ImageFormatRgba16ui,
                            spv::ImageFormatRgba8ui, spv::ImageFormatUnknown});
  }

  std::map<std::uint32_t, std::string> names_;
  std::map<std::uint32_t, spv::ImageFormat> types_;    // formats of images and of pointers to them
  std::map<std::uint32_t, spv::ImageFormat> formats_;  // by variable
  std::map<std::uint32_t, std::uint32_t> variables_;   // of the images that were loaded
  std::set<std::uint32_t> read_;
  std::set<std::uint32_t> written_;
};

// Finds the first `> name`, before `after` if it is not empty.
SourcePlace declaration(const std::string& name, const std::string& after, const std::string& text,
                        const std::string& file) {
  const std::vector<hlsl::Token> tokens = hlsl::lex(text);
  for (std::size_t at = 1; at + 1 < tokens.size(); ++at)
    if (tokens[at].spelling == name && tokens[at - 1].spelling == ">" &&
        (after.empty() || tokens[at + 1].spelling == after))
      return place_of(tokens[at], file);
  return {};
}

}  // namespace

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
  find(gathers_at_a_variable_offset, essl,
       "a gather with an offset that is not constant needs OpenGL ES 3.2: write a constant offset, or leave "
       "gles3 "
       "out with #pragma exclude_renderers");
  const std::vector<Target> msl =
      targets_of([](Target target) { return target_language(target) == TargetLanguage::msl; });
  for (hlsl::Diagnostic& problem : BufferSizeSearch(module).run())
    problems.push_back({msl, std::move(problem)});
  for (const WrittenImages::Found& image : WrittenImages().run(module)) {
    const std::string why = image.has_format ? "' is read and written: in OpenGL ES only images of one "
                                               "float, int or uint may be; declare two, or leave "
                                             : "' has a format that OpenGL ES does not have for images: "
                                               "declare one or four components, or leave ";
    problems.push_back({essl, error_at(declaration(image.name, {}, text, file),
                                       "'" + image.name + why + "gles3 out with #pragma exclude_renderers")});
  }
  for (const std::string& name : BufferArrays().run(module))
    problems.push_back(
        {{Target::hlsl50},
         error_at(
             declaration(name, "[", text, file),
             "'" + name +
                 "' is an array of constant buffers, which needs shader model 5.1, and Direct3D 11 has 5.0: "
                 "declare one cbuffer with an array in it")});
  return problems;
}

}  // namespace penumbra::shaders
