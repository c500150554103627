// Numbers and texts as the package's C# writes them.
#pragma once

#include <string>

namespace penumbra::techniques {

// Returns the shortest literal that is this float: 0.53f, 100.0f.
std::string csharp_float(double value);

// Returns the text in quotes. It escapes characters that C# reads otherwise, and those that do not stay in a
// line (input/text_line.h).
std::string csharp_text(const std::string& text);

// Returns the C# name for a name of a manifest: crisp-noon becomes CrispNoon, 3-taps becomes Of3Taps.
std::string csharp_name(const std::string& name);

}  // namespace penumbra::techniques
