// Reads stripping files, and what Unity writes as text: the pipeline's assets, a project's settings,
// materials, ShaderVariantCollections and players' logs.
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "variants/build_settings.h"
#include "variants/narrowing.h"
#include "variants/urp_settings.h"
#include "variants/used_variants.h"

namespace penumbra::fuzz {

void targets::stripping(std::string_view bytes) {
  read([&] {
    variants::BuildSettings settings;
    variants::parse_build_settings(bytes, "settings", settings);
  });
  for (const char* file : {"a.mat", "a.shadervariants", "Player.log"})
    read([&] {
      variants::UsedVariants used;
      used.add(bytes, file);
      used.narrow({}, "Shader", "0123", "0.1");
    });
  read([&] { variants::parse_stripping(bytes, "stripping.json"); });
  read([&] {
    const variants::UrpSettings settings = variants::read_urp_asset(bytes, "asset");
    variants::clauses_of(variants::widest(settings, variants::combined({}, settings)), "asset");
    variants::unused_passes(settings);
  });
}

}  // namespace penumbra::fuzz
