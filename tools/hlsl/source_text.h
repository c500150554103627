// The text of shader files as the compiler and a reader of its messages see it: one line ending, no byte
// order mark, lines by number.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra::hlsl {

// CRLF and lone CR become LF; a UTF-8 byte order mark is dropped. Columns are counted in this text.
std::string normalise_source(std::string_view bytes);

// Either a text or the reason why there is none ("is a directory", "No such file or directory").
struct SourceRead {
  std::string text;
  std::string problem;  // empty when the text was read
};
// #line directives of the file are blanked: a message belongs where it can be seen.
SourceRead read_source(const std::filesystem::path& file);

// Every text of one compilation, by the name messages call it.
class SourceFiles {
 public:
  void add(const std::string& name, std::string text);
  bool contains(const std::string& name) const { return texts_.count(name) != 0; }
  const std::string& text(const std::string& name) const { return texts_.at(name); }
  const std::vector<std::string>& names() const { return names_; }  // in the order they were read
  // The text of a 1-based line; empty when there is no such file or line.
  std::string line(const std::string& name, int number) const;

 private:
  std::map<std::string, std::string> texts_;
  std::vector<std::string> names_;
};

}  // namespace penumbra::hlsl
