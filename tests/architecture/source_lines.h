// Reads a tree's includes, line by line.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "architecture/rules.h"

namespace penumbra::architecture {

struct Include {
  std::string path;  // path of the including file
  int line;
  std::string target;  // between the quotes or brackets
};

// The includes of C++ and HLSL files whose path begins with prefix.
std::vector<Include> includes_of(const Tree& tree, std::string_view prefix);

void for_each_line(const std::string& text,
                   const std::function<void(int line, const std::string& text)>& visit);

std::string violation(const std::string& path, int line, const std::string& why);

// The folder below prefix: "tools/measurement/scene/frame.cpp" gives "scene". Empty when the path has no
// folder below it.
std::string folder_below(std::string_view path, std::string_view prefix);

}  // namespace penumbra::architecture
