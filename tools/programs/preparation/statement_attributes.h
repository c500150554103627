// Attributes of statements that control FXC's code generation and do not change results: [fastopt],
// [allow_uav_condition], [forcecase], [call], and [maxtessfactor()] of a hull program, a hint for the
// tessellator. glslang warns that they "do not apply"; they are removed.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void drop_statement_attributes(TokenText& text);

}  // namespace penumbra::preparation
