// Settings of a frame (--config) and dumped matrices (--matrices).
#include "fuzz/fuzz_input.h"
#include "input/located_json.h"
#include "parameters/matrices_input.h"
#include "parameters/settings_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace penumbra;
  fuzz::read([&] {
    const LocatedJson document = LocatedJson::parse(fuzz::text_of(data, size), "settings.json");
    fuzz::read([&] { parameters::read_settings(document); });
    fuzz::read([&] { parameters::read_matrices(document); });
  });
  return 0;
}
