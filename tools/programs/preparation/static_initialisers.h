// Static constants whose initialiser calls a function of the text:
// `static const float weights[2] = { Gauss(0), Gauss(1) };`. glslang counts the call as one by whatever
// function stands before it: it then finds a function that calls itself, or drops the callee as unused and
// ends the process. The value is worked out in a function of its own, and every function that reads the
// constant begins with a local of that name and that value.
//
// Constants only, for these have one value wherever they are read; arrays need their sizes. A function with a
// parameter of the same name does not read the constant.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void work_out_static_initialisers(TokenText& text);

}  // namespace penumbra::preparation
