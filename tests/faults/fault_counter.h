// Every call that may be made to fail asks here. The header is internal to injected_fault.h.
#pragma once

namespace penumbra::faults {

enum class FileCall { reads, changes };

bool allocation_fails();
int file_call_fails(FileCall call);  // errno of the failure; 0: the call goes on

}  // namespace penumbra::faults
