#include "platform/build_identity.h"

#include <filesystem>
#include <string_view>

#include "platform/content_hash.h"
#include "platform/terminal.h"

#ifdef __linux__
#include <link.h>

#include <cstddef>
#endif

namespace penumbra::platform {
namespace {

void add_file(ContentHash& hash, const std::filesystem::path& file) {
  std::error_code ignored;
  hash.update(file.string()).update(std::filesystem::file_size(file, ignored));
  hash.update(std::filesystem::last_write_time(file, ignored).time_since_epoch().count());
}

#ifdef __linux__

std::size_t padded(std::size_t size) {
  return (size + 3) / 4 * 4;
}

// Returns the build id among the notes of one segment; empty when there is none.
std::string_view build_id(const char* notes, std::size_t size) {
  for (std::size_t at = 0; at + sizeof(ElfW(Nhdr)) <= size;) {
    const auto* note = reinterpret_cast<const ElfW(Nhdr)*>(notes + at);
    const std::size_t name = at + sizeof *note;
    const std::size_t content = name + padded(note->n_namesz);
    if (content + note->n_descsz > size) break;
    const std::string_view owner(notes + name, note->n_namesz);
    if (note->n_type == NT_GNU_BUILD_ID && owner == std::string_view("GNU\0", 4))
      return {notes + content, note->n_descsz};
    at = content + padded(note->n_descsz);
  }
  return {};
}

int add_object(dl_phdr_info* object, std::size_t, void* state) {
  auto& hash = *static_cast<ContentHash*>(state);
  const std::string_view name = object->dlpi_name;
  // The kernel's own object (vDSO) does not affect results.
  if (!name.empty() && name.find('/') == std::string_view::npos) return 0;
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = object->dlpi_phdr[i];
    if (segment.p_type != PT_NOTE) continue;
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the loader gives addresses as numbers
    const auto* notes = reinterpret_cast<const char*>(object->dlpi_addr + segment.p_vaddr);
    const std::string_view id = build_id(notes, segment.p_memsz);
    if (id.empty()) continue;
    hash.update(id);
    return 0;
  }
  add_file(hash, name.empty() ? program_path() : std::filesystem::path(name));
  return 0;
}

std::string identity() {
  ContentHash hash;
  dl_iterate_phdr(add_object, &hash);
  return hash.hex();
}

#else

std::string identity() {
  ContentHash hash;
  add_file(hash, program_path());
  return hash.hex();
}

#endif

}  // namespace

const std::string& build_identity() {
  static const std::string text = identity();
  return text;
}

namespace {

// The identity is computed before main, while only what the program links is loaded. Libraries load others
// when they need them, and an identity with those would depend on earlier computations.
[[maybe_unused]] const std::string& at_start = build_identity();

}  // namespace

}  // namespace penumbra::platform
