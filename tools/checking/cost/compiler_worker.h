// The process in which `penumbra cost` compiles: the program, started with this argument.
#pragma once

#include <string>
#include <vector>

namespace penumbra::cost {

inline constexpr const char* compiler_worker_mode = "cost-compiler";

int serve_compiler(
    const std::vector<std::string>& arguments);  // behind the mode; the exit code of the process

}  // namespace penumbra::cost
