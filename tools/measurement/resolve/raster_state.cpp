#include "resolve/raster_state.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include "input/input_error.h"

namespace penumbra::resolve {
namespace {

using shaderlab::RenderCommand;
using Words = std::vector<std::string>;

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// One command of a pass, in lower case: ShaderLab's words may be written in either case.
struct State {
  const RenderCommand& command;
  const std::string& pass;
  Words values;

  State(const RenderCommand& of, const std::string& in) : command(of), pass(in) {
    for (const std::string& value : of.values) values.push_back(lower(value));
  }

  [[noreturn]] void refuse(const std::string& remedy) const {
    std::string written = command.name;
    for (const std::string& value : command.values) written += " " + value;
    throw InputError(pass + ":" + std::to_string(command.place.line), "'" + written + "' is not drawn here",
                     remedy);
  }
  bool is(const Words& words) const { return values == words; }
  // ShaderLab takes On, True or 1 against Off, False or 0.
  bool on() const {
    if (is({"on"}) || is({"true"}) || is({"1"})) return true;
    if (is({"off"}) || is({"false"}) || is({"0"})) return false;
    refuse("give it On or Off");
  }
  float number(std::size_t at) const {
    float result = 0.0F;
    if (at >= values.size()) refuse("it has two numbers");
    const std::string& text = values[at];
    const auto read = std::from_chars(text.data(), text.data() + text.size(), result);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size()) refuse("it has two numbers");
    return result;
  }
};

gpu::DepthTest depth_test(const State& state, bool reversed_z) {
  using gpu::DepthTest;
  if (state.is({"less"}) || state.is({"2"})) return reversed_z ? DepthTest::greater : DepthTest::less;
  if (state.is({"lequal"}) || state.is({"4"}))
    return reversed_z ? DepthTest::greater_equal : DepthTest::less_equal;
  if (state.is({"greater"}) || state.is({"5"})) return reversed_z ? DepthTest::less : DepthTest::greater;
  if (state.is({"gequal"}) || state.is({"7"}))
    return reversed_z ? DepthTest::less_equal : DepthTest::greater_equal;
  if (state.is({"equal"}) || state.is({"3"})) return DepthTest::equal;
  if (state.is({"always"}) || state.is({"8"}) || state.is({"off"}) || state.is({"0"}))
    return DepthTest::always;
  state.refuse("the depth tests are Less, LEqual, Equal, GEqual, Greater and Always");
}

gpu::StencilTest stencil_test(const State& state) {
  using gpu::StencilTest;
  constexpr std::array tests{"never", "less", "equal", "lequal", "greater", "notequal", "gequal", "always"};
  for (std::size_t at = 0; at < tests.size(); ++at)
    if (state.is({tests[at]}) || state.is({std::to_string(at + 1)})) return static_cast<StencilTest>(at);
  if (state.is({"0"}) || state.is({"disabled"})) return StencilTest::always;
  state.refuse("the tests are Never, Less, Equal, LEqual, Greater, NotEqual, GEqual and Always");
}

gpu::StencilOperation stencil_operation(const State& state) {
  using gpu::StencilOperation;
  // The order is that of UnityEngine.Rendering.StencilOp.
  constexpr std::array<std::pair<const char*, StencilOperation>, 8> operations{
      {{"keep", StencilOperation::keep},
       {"zero", StencilOperation::zero},
       {"replace", StencilOperation::replace},
       {"incrsat", StencilOperation::increment},
       {"decrsat", StencilOperation::decrement},
       {"invert", StencilOperation::invert},
       {"incrwrap", StencilOperation::increment_wrap},
       {"decrwrap", StencilOperation::decrement_wrap}}};
  for (std::size_t at = 0; at < operations.size(); ++at)
    if (state.is({operations[at].first}) || state.is({std::to_string(at)})) return operations[at].second;
  state.refuse("the operations are Keep, Zero, Replace, IncrSat, DecrSat, Invert, IncrWrap and DecrWrap");
}

std::uint8_t stencil_number(const State& state) {
  int number = -1;
  const std::string text = state.values.size() == 1 ? state.values.front() : "";
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() || number < 0 || number > 255)
    state.refuse("it takes a number from 0 to 255");
  return static_cast<std::uint8_t>(number);
}

// Comp, Pass, Fail and ZFail apply to both faces; with the suffix Front or Back they apply to one.
gpu::StencilState stencil_state(const RenderCommand& command, const std::string& pass) {
  gpu::StencilState result;
  for (const RenderCommand& inner : command.block) {
    const State state(inner, pass);
    std::string name = lower(inner.name);
    if (name == "ref") {
      result.reference = stencil_number(state);
    } else if (name == "readmask") {
      result.read_mask = stencil_number(state);
    } else if (name == "writemask") {
      result.write_mask = stencil_number(state);
    } else {
      const bool front = name.ends_with("front"), back = name.ends_with("back");
      if (front) name.resize(name.size() - 5);
      if (back) name.resize(name.size() - 4);
      for (gpu::StencilFace* face : {&result.front, &result.back}) {
        if ((front && face != &result.front) || (back && face != &result.back)) continue;
        if (name == "comp")
          face->test = stencil_test(state);
        else if (name == "pass")
          face->pass = stencil_operation(state);
        else if (name == "fail")
          face->fail = stencil_operation(state);
        else if (name == "zfail")
          face->depth_fail = stencil_operation(state);
        else
          state.refuse("there is no such state here");
      }
    }
  }
  return result;
}

// A leading number names a target, unless nothing follows it.
std::optional<std::size_t> target_of(Words& values) {
  if (values.size() < 2 || values.front().size() != 1 ||
      std::isdigit(static_cast<unsigned char>(values.front()[0])) == 0)
    return std::nullopt;
  const auto target = static_cast<std::size_t>(values.front()[0] - '0');
  values.erase(values.begin());
  return target;
}

// The states that Blend and BlendOp give each target.
struct BlendStates {
  std::vector<gpu::Blend> factors;
  std::vector<std::optional<gpu::Blend>> operations;  // Min and Max ignore the factors

  explicit BlendStates(std::size_t targets) : factors(targets, gpu::Blend::none), operations(targets) {}

  void set_factors(const State& state) {
    Words values = state.values;
    const std::optional<std::size_t> target = target_of(values);
    if (values.size() == 4 && values[0] == values[2] && values[1] == values[3]) values.resize(2);
    if (values == Words{"off"} || values == Words{"one", "zero"})
      assign(factors, target, gpu::Blend::none);
    else if (values == Words{"one", "one"})
      assign(factors, target, gpu::Blend::add);
    else if (values == Words{"srcalpha", "oneminussrcalpha"})
      assign(factors, target, gpu::Blend::alpha);
    else
      state.refuse("colours are replaced, added (One One) or mixed (SrcAlpha OneMinusSrcAlpha), alpha alike");
  }

  void set_operations(const State& state) {
    Words values = state.values;
    const std::optional<std::size_t> target = target_of(values);
    if (values.size() == 2 && values[0] == values[1]) values.resize(1);
    if (values == Words{"add"})
      assign(operations, target, std::optional<gpu::Blend>());
    else if (values == Words{"min"})
      assign(operations, target, std::optional(gpu::Blend::smallest));
    else if (values == Words{"max"})
      assign(operations, target, std::optional(gpu::Blend::largest));
    else
      state.refuse("the operations are Add, Min and Max, for alpha alike");
  }

  std::vector<gpu::Blend> result() const {
    std::vector<gpu::Blend> blends = factors;
    for (std::size_t i = 0; i < blends.size(); ++i) {
      // Unity, too, blends only where Blend says so.
      if (operations[i] && blends[i] != gpu::Blend::none) blends[i] = *operations[i];
    }
    return blends;
  }

 private:
  template <typename Value>
  static void assign(std::vector<Value>& values, std::optional<std::size_t> target, const Value& value) {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!target || *target == i) values[i] = value;
  }
};

bool is_whole_mask(const std::string& mask) {
  return mask.size() == 4 && std::all_of(mask.begin(), mask.end(), [&](char c) {
           return std::string_view("rgba").find(c) != std::string_view::npos &&
                  std::count(mask.begin(), mask.end(), c) == 1;
         });
}

}  // namespace

RasterState raster_state(const std::vector<RenderCommand>& commands, const std::string& pass,
                         std::size_t targets, bool reversed_z, StencilTarget stencil) {
  RasterState result;
  if (reversed_z) result.depth_test = gpu::DepthTest::greater_equal;
  const float away_from_viewer = reversed_z ? -1.0F : 1.0F;
  BlendStates blends(targets);
  for (const RenderCommand& command : commands) {
    const State state(command, pass);
    const std::string name = lower(command.name);
    if (name == "cull") {
      result.both_faces = state.is({"off"}) || state.is({"false"}) || state.is({"0"});
    } else if (name == "ztest") {
      result.depth_test = depth_test(state, reversed_z);
    } else if (name == "zwrite") {
      result.depth_write = state.on();
    } else if (name == "zclip") {
      result.depth_clamp = !state.on();
    } else if (name == "offset") {
      result.slope_depth_bias = away_from_viewer * state.number(0);
      result.constant_depth_bias = away_from_viewer * state.number(1);
    } else if (name == "blend") {
      blends.set_factors(state);
    } else if (name == "blendop") {
      blends.set_operations(state);
    } else if (name == "colormask") {
      Words mask = state.values;
      if (!mask.empty() && targets > 0 && !is_whole_mask(mask.front()))
        state.refuse("all channels are written: RGBA");
    } else if (name == "stencil") {
      if (stencil == StencilTarget::none)
        state.refuse("the pass has no stencil: name one in its manifest's \"stencil\"");
      result.stencil = stencil_state(command, pass);
    } else if ((name == "alphatomask" || name == "conservative") && state.on()) {
      state.refuse("there is no such state here");
    }
  }
  result.blends = blends.result();
  return result;
}

}  // namespace penumbra::resolve
