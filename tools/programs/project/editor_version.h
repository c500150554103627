// The Unity editor's version, and the number that its shaders see as UNITY_VERSION.
//
// Unity manual, "Branch based on Unity version": YYYYMP up to 2023 (2022.3.0 is 202230), 6MMMPPPP from Unity
// 6 (6000.2.3 is 60020003). For a patch above 9 the page says only that it cannot be tested for. The editor
// does not clamp it but carries into the next digit: shader code that 2017.4.18 generated has UNITY_VERSION
// 201758, and there was no 2017.5.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace penumbra::project {

struct EditorVersion {
  int major = 0;     // 2022, 6000
  int minor = 0;     // 3
  int patch = 0;     // 20
  std::string text;  // 2022.3.20f1
};

// Parses "2022.3.20f1" and similar; returns nothing if the text does not begin with three numbers.
std::optional<EditorVersion> parse_editor_version(std::string_view text);

int unity_version_number(const EditorVersion& version);

}  // namespace penumbra::project
