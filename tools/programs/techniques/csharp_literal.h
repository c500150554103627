// Numbers and texts as the package's C# writes them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace penumbra::techniques {

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

}  // namespace penumbra::techniques
