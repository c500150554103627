// The system calls that are allowed in a process that reads untrusted files. Internal to this folder.
#pragma once

namespace penumbra::platform {

// Installs the filter for all threads of this process, irrevocably: every other call fails with EPERM.
// Returns 0, or the kernel's error; also 0 if the program was built without libseccomp, which filters
// nothing.
int filter_system_calls();

// A wider filter for another program that this process becomes: it refuses sockets but local ones, and the
// calls with which a process reaches into others, into the kernel or into the file system's mounts. Returns
// as above.
int filter_foreign_calls();

}  // namespace penumbra::platform
