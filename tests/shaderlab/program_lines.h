// Reads a program's text as a preprocessor counts its lines, to compare it with the file it came from.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "shaderlab/programs.h"

namespace penumbra::shaderlab {

struct Line {
  int number;
  std::string text;  // without blanks at the end
};

// The lines with code, numbered as a preprocessor does.
inline std::vector<Line> code_lines(const std::string& text) {
  std::vector<Line> lines;
  std::istringstream stream(text);
  int number = 1;
  for (std::string line; std::getline(stream, line); ++number) {
    if (line.rfind("#line ", 0) == 0) {
      number = std::stoi(line.substr(6)) - 1;
      continue;
    }
    const std::size_t last = line.find_last_not_of(' ');
    if (last != std::string::npos) lines.push_back({number, line.substr(0, last + 1)});
  }
  return lines;
}

// Expects every line of code to stand in the file at that line and column, with nothing but blanks before it.
inline void expect_places_of_the_file(const Program& program, const std::string& file) {
  std::vector<std::string> lines{""};
  std::istringstream stream(file);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  for (const Line& line : code_lines(program.text)) {
    ASSERT_LT(static_cast<std::size_t>(line.number), lines.size());
    const std::string& original = lines[static_cast<std::size_t>(line.number)];
    ASSERT_LE(line.text.size(), original.size());
    for (std::size_t i = 0; i < line.text.size(); ++i)
      EXPECT_TRUE(line.text[i] == original[i] || line.text[i] == ' ') << line.number << ":" << i + 1;
  }
}

}  // namespace penumbra::shaderlab
