#include "validation/unit_message.h"

#include <utility>

#include "platform/byte_stream.h"
#include "platform/content_hash.h"

namespace penumbra::validation {

using platform::ByteReader;
using platform::ByteWriter;

namespace {

// Reads nothing, or the result of `decode`; puts the reader into its error state if the text cannot be
// decoded.
template <typename Value, typename Decode>
std::optional<Value> read_optional(ByteReader& in, const Decode& decode) {
  if (!in.flag()) return std::nullopt;
  std::optional<Value> value = decode(in.text());
  if (!value) in.spoil();
  return value;
}

template <typename Value>
void write_optional(ByteWriter& out, const std::optional<Value>& value) {
  out.number(value ? 1 : 0);
  if (value) out.text(encode(*value));
}

// The key is checked, because it becomes the name of a file.
EntryToKeep read_entry(ByteReader& in) {
  EntryToKeep entry;
  const std::uint64_t kind = in.number();
  entry.key = in.text();
  entry.content = in.text();
  if (kind > static_cast<std::uint64_t>(EntryKind::emitted) || !platform::is_content_hash(entry.key))
    in.spoil();
  else
    entry.kind = static_cast<EntryKind>(kind);
  return entry;
}

}  // namespace

std::string encode(const UnitJob& job) {
  ByteWriter out;
  out.text(encode(job.unit));
  out.text(job.context.cache.string());
  out.text(job.context.build);
  out.list(job.context.drivers, [&](const auto& driver) {
    out.text(driver.first);
    out.text(driver.second);
  });
  out.list(job.given_up, [&](const std::string& target) { out.text(target); });
  out.number(static_cast<std::uint64_t>(job.sharing));
  out.number(job.text_only ? 1 : 0);
  out.number(job.wants_emitted ? 1 : 0);
  return out.take();
}

std::optional<UnitJob> decode_job(std::string_view bytes) {
  ByteReader in(bytes);
  std::optional<CompileUnit> unit = decode_unit(in.text());
  if (!unit) return std::nullopt;
  UnitJob job;
  job.unit = *std::move(unit);
  job.context.cache = in.text();
  job.context.build = in.text();
  for (auto& driver : in.list<std::pair<std::string, std::string>>([&] {
         std::string target = in.text();
         return std::pair(std::move(target), in.text());
       }))
    job.context.drivers.insert(std::move(driver));
  job.given_up = in.list<std::string>([&] { return in.text(); });
  const std::uint64_t sharing = in.number();
  if (sharing > static_cast<std::uint64_t>(Sharing::everything)) return std::nullopt;
  job.sharing = static_cast<Sharing>(sharing);
  job.text_only = in.flag();
  job.wants_emitted = in.flag();
  if (!in.exhausted()) return std::nullopt;
  return job;
}

std::string encode(const UnitReply& reply) {
  ByteWriter out;
  out.text(reply.text_key);
  write_optional(out, reply.compile);
  write_optional(out, reply.emitted);
  out.list(reply.dependencies, [&](const std::filesystem::path& file) { out.text(file.string()); });
  out.number(reply.compile_cached ? 1 : 0);
  out.number(reply.emitted_cached ? 1 : 0);
  out.text(reply.text);
  out.list(reply.emitted_texts, [&](const auto& emitted) {
    out.text(emitted.first);
    out.text(emitted.second);
  });
  out.number(reply.damaged);
  out.list(reply.to_keep, [&](const EntryToKeep& entry) {
    out.number(static_cast<std::uint64_t>(entry.kind));
    out.text(entry.key);
    out.text(entry.content);
  });
  return out.take();
}

std::optional<UnitReply> decode_reply(std::string_view bytes) {
  ByteReader in(bytes);
  UnitReply reply;
  reply.text_key = in.text();
  reply.compile = read_optional<CompileAnswer>(in, decode_compile_answer);
  reply.emitted = read_optional<EmittedAnswer>(in, decode_emitted_answer);
  reply.dependencies = in.list<std::filesystem::path>([&] { return std::filesystem::path(in.text()); });
  reply.compile_cached = in.flag();
  reply.emitted_cached = in.flag();
  reply.text = in.text();
  reply.emitted_texts = in.list<std::pair<std::string, std::string>>([&] {
    std::string target = in.text();
    return std::pair(std::move(target), in.text());
  });
  reply.damaged = in.number();
  reply.to_keep = in.list<EntryToKeep>([&] { return read_entry(in); });
  if (!in.exhausted()) return std::nullopt;
  return reply;
}

}  // namespace penumbra::validation
