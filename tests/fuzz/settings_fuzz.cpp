// Reads settings of a frame (--config) and dumped matrices (--matrices).
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "input/located_json.h"
#include "parameters/matrices_input.h"
#include "parameters/settings_input.h"

namespace penumbra::fuzz {

void targets::settings(std::string_view bytes) {
  read([&] {
    const LocatedJson document = LocatedJson::parse(bytes, "settings.json");
    read([&] { parameters::read_settings(document); });
    read([&] { parameters::read_matrices(document); });
  });
}

}  // namespace penumbra::fuzz
