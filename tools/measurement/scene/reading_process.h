// Reads models and pictures in a worker process with dropped privileges (platform/confinement.h): libraries
// that read dozens of formats crash, hang and exhaust memory on malicious files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "platform/worker_pool.h"
#include "scene/material.h"

namespace penumbra::scene {

struct Scene;
struct ImportOptions;

inline constexpr const char* reading_mode = "scene-reader";

struct ReadingProcess {
  // These arguments start this program as serve_readings(): {reading_mode} for a program whose main() knows
  // it. Without any, the file is read in this process, without isolation.
  std::vector<std::string> arguments;
  platform::WorkerLimits limits{.answer = std::size_t{4} << 30};
};

// These read as import() and read_image() do, in this process or in the other one. They throw InputError
// naming the file as well when the other process dies, hangs, or takes more than it may.
Scene import_apart(const std::filesystem::path& file, const ImportOptions& options);
Texture read_image_apart(const std::filesystem::path& file, const ReadingProcess& process);

int serve_readings();  // main() of the other process; returns its exit code

}  // namespace penumbra::scene
