// A folder of shader files that goes with the test, and one-line compilations in it.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "shaders/compile.h"

namespace penumbra::shaders {

class ShaderFiles {
 public:
  ShaderFiles() {
    static int count = 0;
    folder_ = std::filesystem::temp_directory_path() /
              ("penumbra-shaders-" + std::to_string(getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(folder_);
  }
  ~ShaderFiles() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  ShaderFiles(const ShaderFiles&) = delete;
  ShaderFiles& operator=(const ShaderFiles&) = delete;

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(path(name).parent_path());
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  // A request for a file of the folder.
  CompileRequest request(const std::string& name, hlsl::Stage stage = hlsl::Stage::compute) const {
    CompileRequest request;
    request.file = path(name);
    request.stage = stage;
    return request;
  }

 private:
  std::filesystem::path folder_;
};

// A compute shader whose body is one expression stored to a buffer; `before` stands in front.
inline std::string compute_shader(const std::string& expression, const std::string& before = {}) {
  return before +
         "RWStructuredBuffer<float> _Out;\n[numthreads(1, 1, 1)]\nvoid Main(uint3 id : "
         "SV_DispatchThreadID)\n{\n" +
         "    _Out[id.x] = " + expression + ";\n}\n";
}

}  // namespace penumbra::shaders
