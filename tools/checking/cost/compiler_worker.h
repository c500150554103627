// The process in which `penumbra cost` compiles: the program, started with this argument.
#pragma once

#include <string>
#include <vector>

namespace penumbra::cost {

inline constexpr const char* compiler_worker_mode = "cost-compiler";

// `arguments` are those behind the mode; returns the exit code of the process.
int serve_compiler(const std::vector<std::string>& arguments);

}  // namespace penumbra::cost
