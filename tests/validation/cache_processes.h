// Runs a process that fills and reads a cache, for the test that kills one.
#pragma once

namespace penumbra::validation {

inline constexpr const char* cache_user_mode = "--use-cache";

int use_cache(int argc, char** argv);  // arguments: mode, cache folder, shader file, first and last salt

}  // namespace penumbra::validation
