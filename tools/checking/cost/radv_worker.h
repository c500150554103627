// The worker's side of null_radv.h, which processes one shader.
#pragma once

#include <iosfwd>
#include <string>

namespace penumbra::cost {

// Reads a SPIR-V module from `input`, has this process's RADV compile it and writes the figures as JSON to
// `output`; with an empty stage it only identifies the device. Does not throw for errors of shader or driver:
// the response contains them. SIGXCPU ends the process after `seconds` of CPU time.
void run_radv_worker(unsigned seconds, const std::string& stage, const std::string& entry,
                     std::istream& input, std::ostream& output);

}  // namespace penumbra::cost
