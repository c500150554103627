#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra::techniques {

// Numbers and texts as the package's C# writes them.
//
// Returns the shortest literal that is this float: 0.53f, 100.0f.
std::string csharp_float(double value);

// Returns the text in quotes. It escapes characters that C# reads otherwise, and those that do not stay in a
// line (input/text_line.h).
std::string csharp_text(const std::string& text);

// Returns the text as a comment that Unity's editors show: C# reads it as XML.
std::string xml_text(const std::string& text);

// Returns the C# name for a name of a manifest: crisp-noon becomes CrispNoon, 3-taps becomes Of3Taps.
std::string csharp_name(const std::string& name);

// Returns the items with commas between them, in lines of at most 120 columns that begin after the indent;
// the first line begins where the list is written, after `begun` characters more.
std::string csharp_list(const std::vector<std::string>& items, std::size_t indent, std::size_t begun = 0);

// Comments of emitted HLSL.
//
// Returns the words of a text in lines of at most 120 columns, or of one word where that is longer. The first
// line begins with `first`, the others with `next`, such as "//"; a line ends with '\n'.
std::string comment_lines(const std::string& text, std::string_view first, std::string_view next);

// Rows of the table of techniques that the renderer feature reads (Runtime/Techniques/Techniques.txt).
//
// Returns the shortest text that is this float.
std::string table_number(double value);

// A row of columns separated by tabs. Throws std::invalid_argument where a column would not stay in its
// place: names and texts of manifests have no control characters (manifest_reader.h).
class TableRow {
 public:
  explicit TableRow(const std::string& kind);
  TableRow& add(std::string_view column);
  TableRow& add(int number) { return add(std::to_string(number)); }
  // The columns that only some rows have: name=value, or a name alone.
  TableRow& option(const std::string& name, const std::string& value);  // left out if the value is empty
  TableRow& option(const std::string& name, int value, int otherwise);
  TableRow& option(const std::string& name, bool is_set);
  std::string line() const { return text_ + "\n"; }

 private:
  std::string text_;
};

}  // namespace penumbra::techniques
