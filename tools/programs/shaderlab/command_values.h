// The words that render state commands take. Internal to this room.
//
// From Unity's reference of each command (https://docs.unity3d.com/Manual/shader-shaderlab-commands.html,
// https://docs.unity3d.com/Manual/SL-LegacyReference.html). Unity's importer ends with a syntax error at any
// other word, and compares without regard to case.
#pragma once

#include <string>

#include "hlsl/diagnostic.h"
#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

enum class Values {
  anything,
  toggle,
  cull,
  comparison,
  blend_factor,
  blend_operation,
  color_mask,
  stencil_operation,
  color_material,
  fog_mode,
  stencil_number,  // Ref, ReadMask, WriteMask
  number           // of any size
};

struct ValueProblem {
  std::string message;  // empty: there is none
  hlsl::Severity severity = hlsl::Severity::error;
};

// What is wrong with a value of that command; nothing with one that it takes and with [_Property]. `ZTest
// On`, which is in no reference and which Unity takes, is a warning. So are numbers that stand for none of
// the values.
ValueProblem value_problem(const std::string& command, Values values, const Command::Value& value);

}  // namespace penumbra::shaderlab
