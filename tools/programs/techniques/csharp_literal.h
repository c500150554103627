// Numbers and texts as the package's C# writes them.
#pragma once

#include <string>

namespace penumbra::techniques {

// The shortest literal that is this float: 0.53f, 100.0f.
std::string csharp_float(double value);

// In quotes; escaped is what C# reads otherwise, and what does not stay in a line (input/text_line.h).
std::string csharp_text(const std::string& text);

// What C# calls something of a manifest: crisp-noon is CrispNoon, 3-taps is Of3Taps.
std::string csharp_name(const std::string& name);

}  // namespace penumbra::techniques
