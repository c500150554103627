#include "shaders/technique_chain.h"

#include <algorithm>
#include <stdexcept>

namespace penumbra::shaders {
namespace {

// In the order in which a chain may have them, each at most once.
const std::vector<PassKind>& pass_kinds() {
  static const std::vector<PassKind> kinds{
      {"mask", {"PenumbraMask"}, {4}, {"shadowMap", "cameraDepth"}},
      {"mask-blur", {"MaskBlurHorizontal", "MaskBlurVertical"}, {4}, {"cameraDepth", "source"}},
      {"resolve", {"Resolve"}, {1, 2}, {"shadowMap", "pointSampler"}},
      {"upsample", {"Upsample"}, {1}, {"cameraDepth", "source"}},
      {"denoise", {"DenoiseHorizontal", "DenoiseVertical"}, {1}, {"cameraDepth", "source"}}};
  return kinds;
}

std::size_t place_of(const std::string& kind) {
  for (std::size_t i = 0; i < pass_kinds().size(); ++i) {
    if (pass_kinds()[i].name == kind) return i;
  }
  throw std::out_of_range("unknown kind of pass '" + kind + "'");
}

std::string order_of_kinds() {
  std::string text;
  for (const PassKind& kind : pass_kinds()) text += (text.empty() ? "" : ", ") + kind.name;
  return text;
}

std::string wrong_scale(const TechniquePass& pass) {
  const std::vector<int>& scales = pass_kind(pass.kind).scales;
  if (std::find(scales.begin(), scales.end(), pass.scale) != scales.end()) return {};
  std::string text = "a pass of kind '" + pass.kind + "' has a scale of";
  for (const int scale : scales) text += (scale == scales.front() ? " " : " or ") + std::to_string(scale);
  return text + ", not " + std::to_string(pass.scale);
}

}  // namespace

const PassKind& pass_kind(const std::string& name) {
  return pass_kinds().at(place_of(name));
}

std::vector<std::string> pass_kind_names() {
  std::vector<std::string> names;
  for (const PassKind& kind : pass_kinds()) names.push_back(kind.name);
  return names;
}

bool has_pass(const Technique& technique, const std::string& kind) {
  return std::any_of(technique.chain.begin(), technique.chain.end(),
                     [&](const TechniquePass& pass) { return pass.kind == kind; });
}

std::vector<std::string> chain_keywords(const Technique& technique) {
  return has_pass(technique, "mask") ? std::vector<std::string>{"_PENUMBRA_MASK"}
                                     : std::vector<std::string>{};
}

ChainProblem chain_problem(const Technique& technique) {
  for (std::size_t i = 0; i < technique.chain.size(); ++i) {
    const TechniquePass& pass = technique.chain[i];
    if (const std::string problem = wrong_scale(pass); !problem.empty()) return {problem, ""};
    if (i > 0 && place_of(technique.chain[i - 1].kind) >= place_of(pass.kind)) {
      return {"'" + pass.kind + "' comes after '" + technique.chain[i - 1].kind + "'",
              "the order is " + order_of_kinds() + ", each once"};
    }
  }
  if (!has_pass(technique, "resolve")) return {"the chain has no resolve pass", "every technique has one"};
  if (!technique.screen && (technique.chain.size() > 1 || technique.resolve().scale != 1)) {
    return {"only a screen technique has a chain of passes", "write \"screen\": true"};
  }
  if (has_pass(technique, "mask") != has_pass(technique, "mask-blur")) {
    return {"'mask' and 'mask-blur' must be used together",
            "a penumbra is wider than the edge that the mask finds"};
  }
  if (has_pass(technique, "upsample") != (technique.resolve().scale == 2)) {
    return {"'upsample' and a resolve pass of scale 2 must be used together", ""};
  }
  return {};
}

}  // namespace penumbra::shaders
