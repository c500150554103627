// The process in which `penumbra cost` compiles: the program, started with this argument.
#pragma once

namespace penumbra::cost {

inline constexpr const char* compiler_worker_mode = "cost-compiler";

int serve_compiler();  // the exit code of the process

}  // namespace penumbra::cost
