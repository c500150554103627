// The text of shader files as the compiler and its diagnostics see it: one line ending, no byte order mark,
// lines by number.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra::hlsl {

// CRLF and lone CR become LF; a UTF-8 byte order mark is dropped. Columns are counted in this text.
std::string normalise_source(std::string_view bytes);

// A text that copies share, or none.
class SharedText {
 public:
  SharedText() = default;
  SharedText(std::string text) : text_(std::make_shared<const std::string>(std::move(text))) {}
  SharedText(const char* text) : SharedText(std::string(text)) {}

  explicit operator bool() const { return text_ != nullptr; }
  bool has_value() const { return text_ != nullptr; }
  const std::string& operator*() const { return *text_; }
  void reset() { text_.reset(); }

 private:
  std::shared_ptr<const std::string> text_;
};

// A text, or the reason why there is none ("is a directory", "No such file or directory").
struct SourceRead {
  std::string text;
  std::string problem;  // empty when the text was read
};
// #line directives of the file are blanked: diagnostics name physical lines.
SourceRead read_source(const std::filesystem::path& file);

// Every text of one compilation, by the name that diagnostics use. Copies share the texts.
class SourceFiles {
 public:
  using Text = std::shared_ptr<const std::string>;

  void add(const std::string& name, std::string text);
  void add(const std::string& name, Text text);
  bool contains(const std::string& name) const { return files().texts.count(name) != 0; }
  const std::string& text(const std::string& name) const { return *files().texts.at(name); }
  // Returns the names in the order in which the files were read.
  const std::vector<std::string>& names() const { return files().names; }
  // Returns the text of a 1-based line; empty when there is no such file or line.
  std::string line(const std::string& name, int number) const;

 private:
  struct Files {
    std::map<std::string, Text> texts;
    std::vector<std::string> names;
  };

  const Files& files() const;

  std::shared_ptr<Files> files_;  // null if there are no texts
};

}  // namespace penumbra::hlsl
