// The system calls that are left to a process that reads untrusted files. Internal to this room.
#pragma once

namespace penumbra::platform {

// For all threads of this process, and for good: every other call fails with EPERM. 0, or the error that the
// kernel gave; 0 as well where the program was built without libseccomp, which filters nothing.
int filter_system_calls();

}  // namespace penumbra::platform
