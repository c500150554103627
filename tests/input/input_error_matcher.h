// EXPECT that a call throws InputError whose message matches.
#pragma once

#include <gmock/gmock.h>

#include "input/input_error.h"

namespace penumbra {

template <typename Call, typename Matcher>
void expect_input_error(Call call, const Matcher& message) {
  try {
    call();
    ADD_FAILURE() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_THAT(std::string(error.what()), message);
  }
}

}  // namespace penumbra
