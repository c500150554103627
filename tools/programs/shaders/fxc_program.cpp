#include "shaders/fxc_program.h"

#include <charconv>

#include "fxc/fxc.h"
#include "fxc/messages.h"
#include "preparation/source_directives.h"

namespace penumbra::shaders {

std::string fxc_profile(const CompileRequest& request) {
  int target = 50;
  for (const auto& [name, value] : request.defines)
    if (name == "SHADER_TARGET") std::from_chars(value.data(), value.data() + value.size(), target);
  return fxc::profile_for(request.stage, target);
}

fxc::Program fxc_program(const CompileRequest& request, const std::string& expanded) {
  return {fxc::text_for_fxc(preparation::with_pragmas(expanded)), request.entry, fxc_profile(request)};
}

}  // namespace penumbra::shaders
