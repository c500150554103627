// Reads a whole file as text, with a size limit: a path from a user or a project may be a device, a pipe
// without a writer, or endless.
#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>

namespace penumbra {

constexpr std::size_t kLargestTextFile = std::size_t{512}
                                         << 20U;  // bytes; reports of 10^5 variants have 10^8

// Reads a file that the user named, which may be a pipe of a shell's <(...). Throws InputError, naming the
// file, if it cannot be opened or read, is a folder or a named pipe, or has more bytes than `largest`.
std::string read_text_file(const std::filesystem::path& file, std::size_t largest = kLargestTextFile);

// Throws InputError for a device, a pipe or a socket; not for a folder, nor for a path that does not exist.
void require_regular_file(const std::filesystem::path& file);

// Reads a file that was found in a project or folder, or that names files beside it. Also refuses what
// require_regular_file() does.
std::string read_found_text_file(const std::filesystem::path& file, std::size_t largest = kLargestTextFile);

// Returns the rest of a stream, or nothing if reading fails, where std::istreambuf_iterator throws.
std::optional<std::string> rest_of(std::istream& stream);

}  // namespace penumbra
