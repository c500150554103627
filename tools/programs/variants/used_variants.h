// The variants that a project uses: those of its materials and ShaderVariantCollections, or those that a
// player has logged.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "variants/keyword_space.h"

namespace penumbra::variants {

// A variant that a player uploaded, from its log (Project Settings > Graphics > Log Shader Compilation).
struct LoggedVariant {
  std::string pass;  // as in the log: the name, or "<Unnamed Pass 1>"
  Keywords keywords;
};

class UsedVariants {
 public:
  // Reads a material, a ShaderVariantCollection (.shadervariants), or any other file as a player's log.
  // Throws InputError for a log without variants, and for binary assets.
  void add(std::string_view text, const std::string& file);

  // Narrows the variants of a shader's pass. `guid` is that of the shader's .meta file.
  //
  // shader_feature sets keep what materials and collections use, as in a player. With a log, all sets keep
  // what the player has uploaded of the pass. Returns nothing if the log has none of it.
  std::optional<Narrowing> narrow(Narrowing narrowing, const std::string& shader, const std::string& guid,
                                  const std::string& pass) const;

 private:
  void add_log(std::string_view text, const std::string& file);

  std::map<std::string, std::vector<Keywords>> materials_;    // by the shader's guid
  std::map<std::string, std::vector<LoggedVariant>> logged_;  // by the shader's name
};

// Reads files, and the .mat and .shadervariants files below folders; links are not followed. Throws
// InputError for a place that is missing.
UsedVariants read_used_variants(const std::vector<std::string>& places);

}  // namespace penumbra::variants
