// A fixture for tests of manifests: it writes files beside a manifest, and reads the manifest with one thing
// changed.
#pragma once

#include <gmock/gmock.h>

#include "input/input_error_matcher.h"
#include "shaders/shader_files.h"
#include "techniques/technique_list.h"

namespace penumbra::techniques {

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

class ManifestTest : public testing::Test {
 protected:
  ManifestTest(std::string manifest, const std::vector<std::string>& beside)
      : manifest_(std::move(manifest)) {
    for (const std::string& name : beside) files_.write(name, "// here\n");
  }

  virtual TechniqueList read(const std::string& text) const {
    return read_technique_list(files_.write(manifest_, text));
  }
  std::string refusal_of(const std::string& text) const {
    return input_error_of([&] { use(read(text)); });
  }
  // Checks that may refuse a list that was read.
  virtual void use(const TechniqueList&) const {}

  // Expects that the message for the text with one thing changed has all of these parts.
  template <typename... Parts>
  void refuse(const std::string& text, const std::string& from, const std::string& to,
              const Parts&... parts) const {
    EXPECT_THAT(refusal_of(replaced(text, from, to)), HasSubstrs(parts...)) << to;
  }

  std::string manifest_;
  shaders::ShaderFiles files_;
};

}  // namespace penumbra::techniques
