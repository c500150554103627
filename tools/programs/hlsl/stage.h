// The stages of Unity's shader programs.
#pragma once

#include <optional>
#include <string_view>

namespace penumbra::hlsl {

enum class Stage { vertex, hull, domain, geometry, fragment, compute };

inline constexpr Stage all_stages[] = {Stage::vertex,   Stage::hull,     Stage::domain,
                                       Stage::geometry, Stage::fragment, Stage::compute};

const char* stage_name(Stage stage);  // the enumerator's name
std::optional<Stage> find_stage(std::string_view name);

}  // namespace penumbra::hlsl
