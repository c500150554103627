// Numbers as source code: one list of named float tables, printed as HLSL, C# or C++. Every float is printed
// with the fewest digits that read back to the same bits.
#pragma once

#include <string>
#include <vector>

namespace penumbra::parameters {

enum class Language { hlsl, csharp, cpp };

struct FloatTable {
  std::string name;     // PascalCase; HLSL prefixes it with kPenumbra
  std::string comment;  // one line
  int columns = 1;      // 1 .. 4 floats an entry, or 16: a row-major 4x4 matrix
  std::vector<float> values;

  std::size_t rows() const { return values.size() / static_cast<std::size_t>(columns); }
};

struct SourceFile {
  std::vector<std::string> comment;  // the file's opening comment, line by line
  std::string name;                  // PascalCase: the C# class, the C++ namespace, the include guard
  std::vector<FloatTable> tables;
};

// Returns the shortest decimal text that reads back to the same float, always with a point or an exponent.
std::string float_literal(float value);

std::string source_text(const SourceFile& file, Language language);

}  // namespace penumbra::parameters
