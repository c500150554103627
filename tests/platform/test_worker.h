// Runs this test program as a worker: worker_pool_test.cpp answers in it.
#pragma once

namespace penumbra::platform {

inline constexpr const char* worker_mode = "--misbehave-on-demand";

}  // namespace penumbra::platform
