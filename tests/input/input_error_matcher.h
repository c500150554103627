// The function returns the text of the InputError that a call throws.
#pragma once

#include <gmock/gmock.h>

#include "has_substrs.h"
#include "input/input_error.h"

namespace penumbra {

template <typename Call>
std::string input_error_of(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

// EXPECT that the call throws one whose message matches.
template <typename Call, typename Matcher>
void expect_input_error(Call call, const Matcher& message) {
  EXPECT_THAT(input_error_of(call), message);
}

}  // namespace penumbra
