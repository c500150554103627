// The fuzz targets: each reads the bytes as one kind of input, and calls require() for what must hold.
#pragma once

#include <string_view>

namespace penumbra::fuzz::targets {

void bake(std::string_view bytes);
void bytecode(std::string_view bytes);
void cache_entries(std::string_view bytes);
void expanded_text(std::string_view bytes);
void figures(std::string_view bytes);
void messages(std::string_view bytes);
void model(std::string_view bytes);
void option_values(std::string_view bytes);
void picture(std::string_view bytes);
void pragmas(std::string_view bytes);
void preparation(std::string_view bytes);
void preprocessing(std::string_view bytes);
void project_files(std::string_view bytes);
void report(std::string_view bytes);
void settings(std::string_view bytes);
void shaderlab(std::string_view bytes);
void source_text(std::string_view bytes);
void stripping(std::string_view bytes);
void technique_list(std::string_view bytes);
void worker_messages(std::string_view bytes);

}  // namespace penumbra::fuzz::targets
