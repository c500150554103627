#include "shaders/compared_gathers.h"

#include <charconv>
#include <map>
#include <string_view>
#include <vector>

#include "shaders/module_rewrite.h"
#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

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

}  // namespace

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

}  // namespace penumbra::shaders
