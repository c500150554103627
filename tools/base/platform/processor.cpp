#include "platform/processor.h"

#include <fstream>
#include <thread>

namespace penumbra::platform {
namespace {

std::string model_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) != 0) continue;
    const std::size_t value = line.find_first_not_of(" \t", line.find(':') + 1);
    if (value != std::string::npos) return line.substr(value);
  }
  return "unknown processor";
}

}  // namespace

std::string processor_name() {
  return model_name() + ", " + std::to_string(std::thread::hardware_concurrency()) + " threads";
}

}  // namespace penumbra::platform
