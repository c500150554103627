// Static constants whose initialiser calls a function of the text: `static const float weights[2] = {
// Gauss(0), Gauss(1) };`. glslang attributes the call to whatever function precedes it: it then reports
// recursion, or drops the callee as unused and crashes. The value is computed in a generated function, and
// every function that reads the constant begins with a local constant of that name and value.
//
// Constants only, because their value is the same everywhere; arrays need explicit sizes. A function with a
// parameter of the same name does not read the constant.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void work_out_static_initialisers(TokenText& text);

}  // namespace penumbra::preparation
