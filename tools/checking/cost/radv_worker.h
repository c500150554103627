// The worker's side of null_radv.h, which processes shaders one after the other.
#pragma once

#include <iosfwd>

namespace penumbra::cost {

// Identifies this process's RADV device, has it compile each SPIR-V module of `input`, and writes the results
// to `output`, a line of JSON for each as soon as it is known. Does not throw for errors of shader or driver:
// the responses contain them. SIGXCPU ends the process after `seconds` of CPU time for one module.
void run_radv_worker(unsigned seconds, std::istream& input, std::ostream& output);

}  // namespace penumbra::cost
