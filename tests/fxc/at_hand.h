// Tests that need FXC are skipped where scripts/setup could not install it (no .NET SDK, no NuGet), and say
// so.
#pragma once

#include <gtest/gtest.h>

#include "fxc/fxc.h"

#define PENUMBRA_NEEDS_FXC() \
  if (!penumbra::fxc::find_fxc().found) GTEST_SKIP() << "no FXC: " << penumbra::fxc::find_fxc().missing
