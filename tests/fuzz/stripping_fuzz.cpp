// Reads stripping files, and the pipeline's assets that Unity writes as text.
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "variants/narrowing.h"
#include "variants/urp_settings.h"

namespace penumbra::fuzz {

void targets::stripping(std::string_view bytes) {
  read([&] { variants::parse_stripping(bytes, "stripping.json"); });
  read([&] {
    const variants::UrpSettings settings = variants::read_urp_asset(bytes, "asset");
    variants::clauses_of(variants::widest(settings, variants::combined({}, settings)), "asset");
    variants::unused_passes(settings);
  });
}

}  // namespace penumbra::fuzz
