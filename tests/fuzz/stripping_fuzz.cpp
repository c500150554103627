// Stripping files, and the pipeline's assets that Unity writes as text.
#include "fuzz/fuzz_input.h"
#include "variants/stripping.h"
#include "variants/urp_settings.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace penumbra;
  const std::string_view text = fuzz::text_of(data, size);
  fuzz::read([&] { variants::parse_stripping(text, "stripping.json"); });
  fuzz::read([&] {
    const variants::UrpSettings settings = variants::read_urp_asset(text, "asset");
    variants::clauses_of(variants::widest(settings, variants::combined({}, settings)), "asset");
    variants::unused_passes(settings);
  });
  return 0;
}
