#include "validation/recall.h"

#include <string>

#include "hlsl/source_text.h"
#include "input/input_error.h"

namespace penumbra::validation {

std::optional<UnitReply> Recall::reply_to(const CompileUnit& unit) {
  const std::string main = unit.compile.file.string();
  if (!unit.compile.text && !files_.hash(main))
    throw InputError(main, "cannot be read: " + hlsl::read_source(main).problem);
  const std::optional<std::string> entry =
      cache_.find(name_of(EntryKind::sources), sources_key(context_, unit));
  const std::optional<SourceRecord> record = entry ? decode_source_record(*entry) : std::nullopt;
  if (!record || !record->is_true(files_)) return std::nullopt;

  UnitReply reply;
  reply.text_key = record->text_key;
  reply.compile = kept_compile_answer(cache_, record->text_key, [&](const std::string& file) {
    if (unit.compile.text && file == main)
      return std::optional(source_hash(hlsl::normalise_source(*unit.compile.text)));
    return files_.hash(file);
  });
  if (!reply.compile) return std::nullopt;
  if (!reply.compile->module_key.empty() && emits(unit)) {
    reply.emitted = kept_emitted_answer(cache_, emitted_key(context_, unit, reply.compile->module_key));
    if (!reply.emitted) return std::nullopt;
  }
  for (const auto& [file, hash] : record->files) reply.dependencies.emplace_back(file);
  reply.compile_cached = reply.emitted_cached = true;
  return reply;
}

}  // namespace penumbra::validation
