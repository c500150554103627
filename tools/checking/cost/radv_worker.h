// The other end of null_radv.h: what the process of one shader does.
#pragma once

#include <iosfwd>
#include <string>

namespace penumbra::cost {

// Reads a SPIR-V module from `input`, has this process's RADV compile it and writes the figures as JSON to
// `output`; with an empty stage only tells which device there is. Never throws for what can go wrong with
// shader or driver: the answer says it. SIGXCPU ends the process after `seconds` of processor time.
void run_radv_worker(unsigned seconds, const std::string& stage, const std::string& entry,
                     std::istream& input, std::ostream& output);

}  // namespace penumbra::cost
