// Looks up cached results of earlier runs whose files are unchanged. Internal to this folder.
#pragma once

#include <cstddef>
#include <optional>

#include "validation/kept_answers.h"
#include "validation/source_record.h"
#include "validation/unit_message.h"

namespace penumbra::validation {

class Recall {
 public:
  explicit Recall(const AnswerContext& context) : context_(context), cache_(context.cache) {}

  // Returns a worker's complete reply, without preprocessing the text, or nothing if any part of it is not
  // cached. Throws InputError if the unit's own file cannot be read.
  std::optional<UnitReply> reply_to(const CompileUnit& unit);

  std::size_t damaged() const { return cache_.damaged(); }

 private:
  const AnswerContext& context_;
  platform::CacheStore cache_;
  FilesNow files_;
};

}  // namespace penumbra::validation
