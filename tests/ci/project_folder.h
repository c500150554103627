// A small project in a folder of its own, and scripts run in it with variables as a CI system sets them.
#pragma once

#include "cli/program.h"

namespace penumbra::ci {

inline const std::string repository = PENUMBRA_SOURCE_DIR;

class ProjectFolder : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    std::filesystem::create_directories(path("Assets"));
    write("Assets/Good.hlsl", "float4 Main(float2 uv : TEXCOORD0) : SV_Target { return uv.xyxy; }\n");
    write("Assets/Broken.hlsl",
          "float4 Main(float2 uv : TEXCOORD0) : SV_Target\n{\n    return uv.xyxy * glow;\n}\n");
  }

  // Runs bash in the project, with nothing of this process's environment but PATH and HOME.
  platform::ChildResult run_in_project(const std::string& script,
                                       const std::vector<std::string>& variables = {}) const {
    platform::ChildCommand command;
    command.program = "env";
    command.arguments = {"-i", "-C", path("").string(), "PATH=/usr/local/bin:/usr/bin:/bin",
                         "HOME=" + path("").string()};
    command.arguments.insert(command.arguments.end(), variables.begin(), variables.end());
    command.arguments.insert(command.arguments.end(), {"bash", "-e", "-o", "pipefail", "-c", script});
    return platform::run_child(command);
  }

  // A program that writes down what it was called with, and ends with the code.
  std::filesystem::path stub_program(int code) const {
    const auto file = write("stub", "#!/bin/bash\nprintf '%s\\n' \"$@\" >>\"" + path("called").string() +
                                        "\"\nexit " + std::to_string(code) + "\n");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    return file;
  }
};

}  // namespace penumbra::ci
