// Waits until another process has ended, however long that takes: where it never does, CTest ends the test.
#pragma once

#include <chrono>
#include <fstream>
#include <string>
#include <thread>

namespace penumbra::platform {

// Zombies are not alive.
inline bool is_alive(int process) {
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string number;
  std::string name;
  char state = 'Z';
  stat >> number >> name >> state;
  return stat && state != 'Z';
}

inline void wait_for_the_end_of(int process) {
  while (is_alive(process)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

}  // namespace penumbra::platform
