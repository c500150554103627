// Attributes of statements that say how FXC should compile them and that change no result: [fastopt],
// [allow_uav_condition], [forcecase], [call]. glslang warns that they "do not apply"; they are taken out.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void drop_statement_attributes(TokenText& text);

}  // namespace penumbra::preparation
