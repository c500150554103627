// Short titles of techniques and adapters, where there is little room: in captions, charts, tables and
// buttons.
#pragma once

#include <string>

namespace penumbra::study {

// Returns the title without its details: for a quality preset, without its passes ("Penumbra High" for
// "Preset High: PCSS 12+24, masked"); for an adapter, without its file ("mine" for "mine (Mine.hlsl)"). Every
// other title is unchanged. Without a title it is the name.
std::string short_title(const std::string& name, const std::string& title);

}  // namespace penumbra::study
