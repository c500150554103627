// Compiles HLSL by FXC, as Unity does for Direct3D 11, and first of all for Vulkan, Metal and OpenGL.
//
// Unity expands includes and macros itself before FXC sees a text: URP 17's Common.hlsl defines a macro with
// an empty list of parameters, which FXC's own preprocessor refuses. So a Judge takes the expanded text
// (shaders::expand).
#pragma once

#include <memory>

#include "fxc/fxc.h"
#include "platform/worker_pool.h"

namespace penumbra::fxc {

struct Program {
  std::string text;  // without includes and macros; #line directives and #pragmas may remain
  std::string entry;
  std::string profile;  // profile_for()
  bool optimise = true;
};

struct Verdict {
  bool compiled = false;
  std::string bytecode;  // a DXBC container; empty unless compiled
  std::string messages;  // FXC's own, one a line: "file(line,columns): warning X3206: text"
};

struct JudgeLimits {
  unsigned processor_seconds = 60;  // limit for one program
  unsigned megabytes = 2048;        // limit for the compiler's process
};

inline JudgeLimits limits_of(const platform::WorkerLimits& limits) {
  return {static_cast<unsigned>(limits.processor_time.count()), static_cast<unsigned>(limits.memory >> 20U)};
}

// A running FXC, which takes about half a second to start and a millisecond for a small program. Not
// thread-safe.
class Judge {
 public:
  // Throws EnvironmentError when FXC does not start. Call it before the process is confined
  // (platform/confinement.h).
  explicit Judge(const Installation& installation, const JudgeLimits& limits = {});
  ~Judge();
  Judge(const Judge&) = delete;
  Judge& operator=(const Judge&) = delete;

  // Throws platform::WorkerSpent where FXC crashes or exceeds a limit: this Judge cannot be used again.
  Verdict compile(const Program& program);

 private:
  struct Process;
  std::unique_ptr<Process> process_;
};

}  // namespace penumbra::fxc
