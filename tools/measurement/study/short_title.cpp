#include "study/short_title.h"

#include <string_view>

#include "techniques/preset_emit.h"

namespace penumbra::study {

std::string short_title(const std::string& name, const std::string& title) {
  if (title.empty()) return name;
  constexpr std::string_view kPreset = "Preset ";
  const std::size_t colon = title.find(": ");
  if (name.starts_with(techniques::preset_prefix) && title.starts_with(kPreset) && colon != std::string::npos)
    return "Penumbra " + title.substr(kPreset.size(), colon - kPreset.size());
  const bool has_file = title.starts_with(name + " (") && title.ends_with(")");
  return has_file ? name : title;
}

}  // namespace penumbra::study
