// Small texts on which compilers crash, or that cost them more time and memory than there is.
#pragma once

#include <string>

namespace penumbra {

// A chain of commas. `function` is the function's head; the body ends in what is returned. glslang calls
// itself for each comma.
inline std::string comma_chain(const std::string& function) {
  std::string text = function + "\n{\n    float a = 0;\n    a += 1";
  for (int i = 0; i < 60'000; ++i) text += ", a += 1";
  return text + ";\n    return 0;\n}\n";
}

// The text needs 2^39 expansions.
inline std::string macro_bomb(const std::string& function) {
  std::string text = "#define M0 1 +\n";
  for (int i = 1; i < 40; ++i) {
    const std::string before = "M" + std::to_string(i - 1);
    text += "#define M" + std::to_string(i) + " " + before + " " + before + "\n";
  }
  return text + function + "\n{\n    return M39 0;\n}\n";
}

inline std::string endless_unrolling(const std::string& function) {
  return "float step;\n" + function +
         "\n{\n    float sum = 0;\n    [unroll] for (int i = 0; i < 1000000000; ++i) sum += step;\n"
         "    return sum;\n}\n";
}

inline std::string deep_parentheses(const std::string& function) {
  return function + "\n{\n    return " + std::string(100'000, '(') + "1" + std::string(100'000, ')') +
         ";\n}\n";
}

}  // namespace penumbra
