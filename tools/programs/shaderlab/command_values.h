// The values of render state commands. Internal to this folder.
//
// They are those of Unity's reference of each command
// (https://docs.unity3d.com/Manual/shader-shaderlab-commands.html,
// https://docs.unity3d.com/Manual/SL-LegacyReference.html). Unity's importer reports a syntax error for any
// other value; the comparison is case-insensitive.
#pragma once

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
  number           // a number of any size
};

struct ValueProblem {
  std::string message;  // empty if there is none
  hlsl::Severity severity = hlsl::Severity::error;
};

// Describes the problem with a value of that command; there is none for a valid value and for [_Property].
// `ZTest On`, which no reference lists and Unity accepts, is a warning. So are numbers that are not a value
// of the enumeration.
ValueProblem value_problem(const std::string& command, Values values, const Command::Value& value);

}  // namespace penumbra::shaderlab
