#include "shaders/target_corrections.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <unordered_set>

#include "hlsl/identifier.h"
#include "shaders/module_rewrite.h"
#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

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

constexpr int marked = 100000;  // offsets are -8 to 7
constexpr std::string_view sample = "SampleCmpLevelZero(";
constexpr std::string_view gather = "GatherCmp(";

class MarkedGathers {
 public:
  explicit MarkedGathers(const SpirvModule& module) : module_(module), to_(module) {}

  std::optional<SpirvModule> run() {
    spirv::for_each_instruction(module_, [this](spirv::Words one) { rewrite(one); });
    return found_ && !refused_ ? std::optional(to_.finished()) : std::nullopt;
  }

 private:
  using Words = ModuleRewrite::Words;
  static constexpr std::size_t mask = 6;

  void rewrite(spirv::Words one) {
    if (spirv::opcode(one) == spv::OpConstant && one.size() == 4) constants_[one[2]] = {one[3]};
    if (spirv::opcode(one) == spv::OpConstantComposite && one.size() == 5) add_composite(one);
    if (spirv::opcode(one) == spv::OpImageDrefGather && one.size() >= mask) return mark(one);
    to_.keep(one);
  }

  void add_composite(spirv::Words one) {
    const auto x = constants_.find(one[3]);
    const auto y = constants_.find(one[4]);
    if (x != constants_.end() && y != constants_.end()) constants_[one[2]] = {x->second[0], y->second[0]};
  }

  void mark(spirv::Words one) {
    found_ = true;
    Words offset{0, 0};
    if (one.size() > mask) {
      const auto given = one.size() == mask + 2 && one[mask] == spv::ImageOperandsConstOffsetMask
                             ? constants_.find(one[mask + 1])
                             : constants_.end();
      refused_ = refused_ || given == constants_.end() || given->second.size() != 2;
      if (refused_) return to_.keep(one);
      offset = given->second;
    }
    to_.result(spv::OpImageSampleDrefExplicitLod, one[1],
               {one[3], one[4], one[5], spv::ImageOperandsLodMask | spv::ImageOperandsConstOffsetMask, zero(),
                offset_constant(offset)},
               one[2]);
  }

  std::uint32_t zero() {
    if (zero_ == 0) zero_ = to_.constant(spv::OpConstant, to_.type(spv::OpTypeFloat, {32}), {0});
    return zero_;
  }

  std::uint32_t offset_constant(const Words& offset) {
    const std::uint32_t type = to_.type(spv::OpTypeInt, {32, 1});
    const std::uint32_t pair = to_.type(spv::OpTypeVector, {type, 2});
    const std::uint32_t x = to_.constant(spv::OpConstant, type, {offset[0] + marked});
    const std::uint32_t y = to_.constant(spv::OpConstant, type, {offset[1]});
    return to_.constant(spv::OpConstantComposite, pair, {x, y});
  }

  const SpirvModule& module_;
  ModuleRewrite to_;
  std::map<std::uint32_t, Words> constants_;  // values of numbers and of pairs
  std::uint32_t zero_ = 0;
  bool found_ = false;
  bool refused_ = false;
};

std::size_t closing(std::string_view text, std::size_t at) {
  for (int depth = 1; at < text.size(); ++at) {
    depth += text[at] == '(' ? 1 : text[at] == ')' ? -1 : 0;
    if (depth == 0) return at;
  }
  return std::string_view::npos;
}

std::optional<spvc_variable_id> layer_output(const SpirvCrossSession& session, spvc_resources resources) {
  const spvc_reflected_builtin_resource* list = nullptr;
  std::size_t count = 0;
  session.require(spvc_resources_get_builtin_resource_list_for_type(
      resources, SPVC_BUILTIN_RESOURCE_TYPE_STAGE_OUTPUT, &list, &count));
  for (std::size_t i = 0; i < count; ++i)
    if (list[i].builtin == SpvBuiltInLayer) return list[i].resource.id;
  return std::nullopt;
}

unsigned free_location(const SpirvCrossSession& session, spvc_resources resources) {
  const spvc_reflected_resource* list = nullptr;
  std::size_t count = 0;
  session.require(
      spvc_resources_get_resource_list_for_type(resources, SPVC_RESOURCE_TYPE_STAGE_OUTPUT, &list, &count));
  unsigned next = 0;
  for (std::size_t i = 0; i < count; ++i)
    next = std::max(next,
                    1 + spvc_compiler_get_decoration(session.compiler(), list[i].id, SpvDecorationLocation));
  return next;
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
    if (!hlsl::continues_identifier(essl[at])) {
      ++at;
      continue;
    }
    std::size_t end = at;
    while (end < essl.size() && hlsl::continues_identifier(essl[end])) ++end;
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

std::optional<SpirvModule> with_marked_gathers(const SpirvModule& module) {
  if (module.size() < spirv::header_words) return std::nullopt;
  return MarkedGathers(module).run();
}

std::string with_named_gathers(std::string hlsl) {
  constexpr std::string_view before_offset = ", int2(";
  for (std::size_t at = hlsl.find(sample); at != std::string::npos; at = hlsl.find(sample, at + 1)) {
    const std::size_t end = closing(hlsl, at + sample.size());
    const std::size_t offset = hlsl.rfind(before_offset, end);
    if (end == std::string::npos || offset == std::string::npos || offset < at) continue;
    int x = 0;
    const std::size_t number = offset + before_offset.size();
    const auto read = std::from_chars(hlsl.data() + number, hlsl.data() + end, x);
    if (read.ec != std::errc() || x < marked / 2) continue;
    const std::size_t number_end = static_cast<std::size_t>(read.ptr - hlsl.data());
    const bool none = x == marked && hlsl.compare(number_end, end - number_end, ", 0)") == 0;
    if (none) {
      hlsl.erase(offset, end - offset);
    } else {
      hlsl.replace(number, number_end - number, std::to_string(x - marked));
    }
    hlsl.replace(at, sample.size(), gather);
  }
  return hlsl;
}

VertexLayer::VertexLayer(const SpirvCrossSession& session, Target target) {
  const spvc_compiler compiler = session.compiler();
  if (spvc_compiler_get_execution_model(compiler) == SpvExecutionModelGeometry) return;
  spvc_resources resources = nullptr;
  session.require(spvc_compiler_create_shader_resources(compiler, &resources));
  const std::optional<spvc_variable_id> layer = layer_output(session, resources);
  if (!layer) return;
  switch (target_language(target)) {
    case TargetLanguage::essl:
      throw std::invalid_argument(
          "OpenGL ES lets no vertex shader choose the layer (SV_RenderTargetArrayIndex); Unity draws both "
          "eyes "
          "by multiview there");
    case TargetLanguage::glsl:
      session.require(spvc_compiler_require_extension(compiler, "GL_ARB_shader_viewport_layer_array"));
      break;
    case TargetLanguage::hlsl: {  // passes through SPIRV-Cross like any other output
      const unsigned location = free_location(session, resources);
      spvc_compiler_unset_decoration(compiler, *layer, SpvDecorationBuiltIn);
      spvc_compiler_set_decoration(compiler, *layer, SpvDecorationLocation, location);
      stand_in_ = " : TEXCOORD" + std::to_string(location) + ";";
      break;
    }
    case TargetLanguage::msl:
      break;
  }
}

std::string VertexLayer::completed(std::string text) const {
  if (stand_in_.empty()) return text;
  // Vertex inputs are TEXCOORDs, too: only the one in the output structure is replaced.
  const std::size_t outputs = text.find("struct SPIRV_Cross_Output");
  const std::size_t at = text.find(stand_in_, outputs);
  if (outputs == std::string::npos || at == std::string::npos || at > text.find('}', outputs))
    throw std::invalid_argument("the layer's output is not in the text that SPIRV-Cross emitted");
  return text.replace(at, stand_in_.size(), " : SV_RenderTargetArrayIndex;");
}

}  // namespace penumbra::shaders
