// Reads HLSL with the preprocessor: it ends, says where each error is, and gives the same answer after
// another source. The first byte says whether the source is prepared.
#include <algorithm>
#include <string>

#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "hlsl/source_text.h"
#include "preparation/source_directives.h"
#include "preprocessing/preprocessor.h"

namespace penumbra::fuzz {

namespace {

constexpr const char* name = "main.hlsl";

class NoIncludes final : public preprocessing::Includes {
 public:
  preprocessing::IncludedFile enter(const std::string&, const std::string&) override {
    return {{}, nullptr, "there are no files"};
  }
  void leave() override {}
};

preprocessing::Preprocessed read(preprocessing::Preprocessor& preprocessor, const std::string& source) {
  const preprocessing::CutSource given = preprocessor.cut("#define GIVEN 1\n#define CALLED(x) (x)\n");
  const preprocessing::CutSource cut = preprocessor.cut(source);
  NoIncludes includes;
  return preprocessor.run(given, cut, name, includes);
}

}  // namespace

void targets::preprocessing(std::string_view bytes) {
  const bool prepared = take_byte(bytes) % 2 == 0;
  std::string source = hlsl::normalise_source(bytes);
  if (prepared) source = preparation::prepare_source(std::move(source));
  const auto lines = std::count(source.begin(), source.end(), '\n') + 1;
  preprocessing::Preprocessor preprocessor;
  const preprocessing::Preprocessed first = read(preprocessor, source);
  const bool wrong = hlsl::has_errors(first.diagnostics);
  require(first.text.empty() == wrong, "there is a text or an error");
  for (const hlsl::Diagnostic& said : first.diagnostics)
    require(said.file == name && said.line > 0 && said.line <= lines && said.column > 0,
            "a message has a place in the source");
  read(preprocessor, "#define GIVEN 2\n#if CALLED(\n");
  require(read(preprocessor, source).text == first.text, "another source before it changes nothing");
}

}  // namespace penumbra::fuzz
