// A long-lived child process for a compiler that is a program of its own and reads untrusted text. Requests
// go to its standard input, and its answers come from its standard output.
//
// Linux: the child may open only the files and folders that are named (Landlock, where the kernel has it), no
// sockets but local ones, and none of the calls with which a process reaches into others (seccomp, where the
// program was built with it). It has limits of memory and file size, no core files, no privileges that a
// program could add, and only the environment that is given. It ends with the thread that started it.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace penumbra::platform {

struct ConfinedCommand {
  std::string program;  // a path
  std::vector<std::string> arguments;
  std::vector<std::pair<std::string, std::string>> environment;  // the child's whole environment
  std::filesystem::path directory;                               // the child's current folder
  std::vector<std::filesystem::path> readable;  // files and folders; those that do not exist are left out
  std::vector<std::filesystem::path> writable;
  std::size_t memory = std::size_t{2} << 30;  // bytes of private memory that may be written
  // A child that sends no byte for so long counts as ended: a limit of processor time does not end one that
  // waits for ever.
  std::chrono::seconds patience = std::chrono::minutes(20);
};

class ConfinedChild {
 public:
  // Throws EnvironmentError if the program cannot be started. POSIX only: elsewhere it throws
  // EnvironmentError.
  explicit ConfinedChild(const ConfinedCommand& command);
  ~ConfinedChild();  // ends it
  ConfinedChild(const ConfinedChild&) = delete;
  ConfinedChild& operator=(const ConfinedChild&) = delete;

  // Both block, and return false when the child has ended, closed its end, or taken more than its patience.
  bool write(std::string_view bytes);
  bool read(char* bytes, std::size_t count);  // reads all of them

 private:
  int process_ = 0;
  int input_ = -1;   // our end of its standard input
  int output_ = -1;  // our end of its standard output
  int ended_ = -1;   // becomes readable when it ends
  std::chrono::milliseconds patience_{};
};

}  // namespace penumbra::platform
