#pragma once

namespace penumbra::validation {

// What units of one run share; less than everything is there to be measured.
enum class Sharing {
  nothing,       // every unit pays for itself
  declarations,  // what a unit does not reach is looked at once (checked_declarations.h)
  everything,    // each text, each reached text and each module once
};

}  // namespace penumbra::validation
