// What a technique or adapter is called where there is little room: in captions, charts, tables and chips.
#pragma once

#include <string>

namespace penumbra::study {

// The title without what it says in detail: of a quality preset, the passes it consists of, and whose it is
// ("Penumbra High" of "Preset High: PCSS 12+24, masked"); of an adapter, its file ("mine" of "mine
// (Mine.hlsl)"). Every other title stays whole. Without a title: the name.
std::string short_title(const std::string& name, const std::string& title);

}  // namespace penumbra::study
