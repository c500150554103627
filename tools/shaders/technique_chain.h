// What a technique's chain may be made of, and in which order. Internal to techniques.json and those who run
// it.
//
//   mask, mask-blur     where a penumbra may be, a quarter of the screen's size
//   resolve             visibility, at the screen's size or half of it
//   upsample            half to full, after a resolve at half
//   denoise             smooths penumbrae
#pragma once

#include <string>
#include <vector>

#include "shaders/technique_list.h"

namespace penumbra::shaders {

struct PassKind {
  std::string name;
  std::vector<std::string> shader_passes;  // of Shaders/PenumbraShadows.shader, in the order they run
  std::vector<int> scales;                 // that what it writes may have
  std::vector<std::string> resources;      // that its function may take
};

const PassKind& pass_kind(const std::string& name);  // throws std::out_of_range for another name
std::vector<std::string> pass_kind_names();

bool has_pass(const Technique& technique, const std::string& kind);

// Keywords that the chain itself switches on in its passes, beside the technique's own.
std::vector<std::string> chain_keywords(const Technique& technique);

struct ChainProblem {
  std::string text;  // empty: the chain is right
  std::string way_out;
};
ChainProblem chain_problem(const Technique& technique);

}  // namespace penumbra::shaders
