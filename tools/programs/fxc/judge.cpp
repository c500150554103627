#include "fxc/judge.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <system_error>
#include <thread>

#include "input/input_error.h"
#include "platform/confined_child.h"
#include "platform/terminal.h"
#include "platform/worker_pool.h"

namespace penumbra::fxc {

namespace {

namespace fs = std::filesystem;

// The flags are those of D3DCOMPILE_*: Unity's are the highest level of optimisation and the compatibility
// with Direct3D 9's semantics.
constexpr std::uint32_t kSkipOptimisation = 1U << 2U;
constexpr std::uint32_t kBackwardsCompatibility = 1U << 12U;
constexpr std::uint32_t kHighestLevel = 1U << 15U;

// The values are those of fxc_worker.c.
constexpr std::uint32_t kCompiled = 0;
constexpr std::uint32_t kTooLong = 2;
constexpr std::uint32_t kTooLarge = 3;

// FXC gets so many seconds of elapsed time for each second of processor time, since a busy machine takes
// longer.
constexpr int kPatience = 20;

constexpr std::uint32_t kLargestAnswer = std::uint32_t{256} << 20U;  // bytes

// Wine takes only plain paths, and only short ones for its server's socket below them.
fs::path folder_for_wine() {
  constexpr std::size_t kLongest = 64;
  const fs::path usual = platform::temporary_directory();
  const std::string& name = usual.native();
  const auto is_plain = [](unsigned char c) {
    return c > ' ' && c < 0x7f && c != '\\' && c != '"' && c != ':';
  };
  const bool fits =
      usual.is_absolute() && name.size() <= kLongest && std::all_of(name.begin(), name.end(), is_plain);
  return fits ? usual : fs::path("/tmp");
}

// A prefix with what Wine needs: two drives. Wine loads its own libraries from where they are installed, and
// starts none of the services of a Windows desktop: that takes half a second in place of twenty.
struct Prefix {
  fs::path folder = platform::new_private_directory("penumbra-fxc", folder_for_wine());

  Prefix() {
    if (folder.empty())
      throw EnvironmentError("no folder for Wine can be made in '" + folder_for_wine().string() +
                             "': point TMPDIR to one that can be written to, with a plain, short path");
    std::error_code error;
    fs::create_directories(folder / "drive_c", error);
    fs::create_directories(folder / "dosdevices", error);
    if (!error) fs::create_directory_symlink("../drive_c", folder / "dosdevices" / "c:", error);
    if (!error) fs::create_directory_symlink("/", folder / "dosdevices" / "z:", error);
    if (!error) return;
    remove();
    throw EnvironmentError("no temporary folder for Wine can be made: " + error.message());
  }
  ~Prefix() { remove(); }
  // Wine's server ends a moment after the program that it served, and writes its registry then.
  void remove_until_quiet() const {
    for (int tries = 0; tries < 75; ++tries) {
      remove();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
  Prefix(const Prefix&) = delete;
  Prefix& operator=(const Prefix&) = delete;

 private:
  // Wine's server does not know of the removal, and may still write its registry.
  void remove() const {
    std::error_code error;
    for (int tries = 0; tries < 100; ++tries) {
      fs::remove_all(folder, error);
      if (!fs::exists(folder, error)) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
};

// Wine takes no path with letters beyond ASCII in the "C" locale, so the file gets a name in the prefix.
std::string windows_path(const fs::path& file, const fs::path& prefix, const char* name) {
  std::error_code error;
  fs::create_symlink(fs::canonical(file), prefix / name, error);
  if (error) throw EnvironmentError("no temporary file for Wine can be made: " + error.message());
  return "Z:" + (prefix / name).string();
}

platform::ConfinedCommand command_of(const Installation& installation, const JudgeLimits& limits,
                                     const fs::path& prefix) {
  platform::ConfinedCommand command;
  command.program = installation.wine.string();
  command.arguments = {windows_path(installation.worker, prefix, "worker.exe"),
                       windows_path(installation.library, prefix, "library.dll"),
                       std::to_string(limits.processor_seconds), std::to_string(limits.megabytes)};
  command.environment = {{"WINEPREFIX", prefix.string()}, {"WINEARCH", "win64"},
                         {"WINEDEBUG", "-all"},           {"WINEBOOTSTRAPMODE", "1"},
                         {"HOME", prefix.string()},       {"WINEDLLOVERRIDES", "wineboot.exe="},
                         {"PATH", "/usr/bin:/bin"},       {"TMPDIR", prefix.string()}};
  command.directory = prefix;
  command.readable = {"/usr",
                      "/lib",
                      "/lib64",
                      installation.wine.parent_path(),
                      fs::canonical(installation.worker),
                      fs::canonical(installation.library)};
  command.writable = {prefix, "/dev/null"};
  command.memory = std::size_t{limits.megabytes} << 20U;
  command.patience = kPatience * std::chrono::seconds(limits.processor_seconds);
  return command;
}

void append(std::string& bytes, std::uint32_t number) {
  for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(number >> shift & 0xFFU);
}

std::uint32_t number_at(const char* bytes) {
  std::uint32_t number = 0;
  for (int i = 3; i >= 0; --i) number = number << 8U | static_cast<unsigned char>(bytes[i]);
  return number;
}

}  // namespace

struct Judge::Process {
  Process(const Installation& installation, const JudgeLimits& of_program, const fs::path& prefix)
      : limits(of_program), child(command_of(installation, of_program, prefix)) {}
  JudgeLimits limits;
  platform::ConfinedChild child;
};

Judge::Judge(const Installation& installation, const JudgeLimits& limits) {
  char ready = 0;
  bool started = false;
  {
    // The prefix is removed when everything that Wine needs is loaded: nothing stays behind, however it ends.
    const Prefix prefix;
    process_ = std::make_unique<Process>(installation, limits, prefix.folder);
    started = process_->child.read(&ready, 1);
    if (!started) {
      process_.reset();
      prefix.remove_until_quiet();
    }
  }
  if (!started)
    throw EnvironmentError("FXC does not start: '" + installation.wine.string() + "' with '" +
                           installation.library.string() + "'; set PENUMBRA_FXC=off to go on without it");
}

Judge::~Judge() = default;

Verdict Judge::compile(const Program& program) {
  std::string request;
  append(request, kBackwardsCompatibility | (program.optimise ? kHighestLevel : kSkipOptimisation));
  for (const std::string* text : {&program.entry, &program.profile, &program.text})
    append(request, static_cast<std::uint32_t>(text->size()));
  for (const std::string* text : {&program.entry, &program.profile, &program.text}) request += *text;
  std::array<char, 12> head;
  if (!process_->child.write(request) || !process_->child.read(head.data(), head.size()))
    throw platform::WorkerSpent("FXC crashed or does not answer");
  const std::uint32_t status = number_at(head.data());
  if (status == kTooLong)
    throw platform::WorkerSpent("took more than " + std::to_string(process_->limits.processor_seconds) +
                                " s of CPU time in FXC");
  if (status == kTooLarge)
    throw platform::WorkerSpent("ran out of memory in FXC, which may take " +
                                std::to_string(process_->limits.megabytes) + " MiB");
  Verdict verdict;
  verdict.compiled = status == kCompiled;
  const std::pair<std::size_t, std::string*> parts[] = {{4, &verdict.bytecode}, {8, &verdict.messages}};
  for (const auto& [at, text] : parts) {
    const std::uint32_t size = number_at(head.data() + at);
    if (size > kLargestAnswer) throw platform::WorkerSpent("FXC sent a malformed answer");
    text->resize(size);
    if (!process_->child.read(text->data(), size)) throw platform::WorkerSpent("FXC crashed");
  }
  while (verdict.messages.ends_with('\0')) verdict.messages.pop_back();
  return verdict;
}

}  // namespace penumbra::fxc
