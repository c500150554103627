// UsePass finds the Pass it names, or says why not where it stands.
#include "shaderlab/use_pass.h"

#include <gtest/gtest.h>

#include "shaderlab/parse.h"

namespace penumbra::shaderlab {
namespace {

Shader shader(const std::string& text) {
  return parse_shader(text, "a.shader").shader;
}

class UsePass : public testing::Test {
 protected:
  FoundPass resolve(const std::string& path) {
    user_ = shader("Shader \"User\" { SubShader {\n  UsePass \"" + path + "\" } }");
    return resolve_use_pass(user_, user_.sub_shaders.at(0).passes.at(0), {&user_, &lit_, &chain_});
  }

  std::string why(const std::string& path) {
    const FoundPass found = resolve(path);
    EXPECT_EQ(found.pass, nullptr);
    return found.diagnostic ? hlsl::format(*found.diagnostic) : "no diagnostic";
  }

  Shader user_;
  Shader lit_ = shader(
      "Shader \"A/Lit\" { SubShader { Pass { } Pass { Name \"Forward\" } GrabPass { \"GRAB\" } }\n"
      "SubShader { Pass { Name \"Forward\" } Pass { Name \"Shadow\" } } }");
  Shader chain_ =
      shader("Shader \"Chain\" { SubShader { UsePass \"A/Lit/SHADOW\" UsePass \"Chain/LOOP\" } }");
};

TEST_F(UsePass, FindsTheFirstPassOfThatNameWithoutRegardToCase) {
  for (const char* path : {"A/Lit/FORWARD", "A/Lit/Forward"}) {
    const FoundPass found = resolve(path);
    EXPECT_FALSE(found.diagnostic.has_value());
    EXPECT_EQ(found.shader, &lit_);
    EXPECT_EQ(found.sub_shader, &lit_.sub_shaders[0]);
    EXPECT_EQ(found.pass, &lit_.sub_shaders[0].passes[1]);
  }
  EXPECT_EQ(resolve("A/Lit/SHADOW").pass, &lit_.sub_shaders[1].passes[1]);
}

TEST_F(UsePass, IsFollowedToThePassItself) {
  EXPECT_EQ(resolve("Chain/SHADOW").pass, &lit_.sub_shaders[1].passes[1]);
}

TEST_F(UsePass, SaysWhatIsMissing) {
  const std::string line = "\n      UsePass \"";
  EXPECT_EQ(why("A/Lit/SHADOWS"),
            "a.shader:2:11: error: the shader \"A/Lit\" has no Pass named SHADOWS: did you mean 'SHADOW'?" +
                line + "A/Lit/SHADOWS\" } }\n              ^");
  EXPECT_EQ(why("A/Lit/META"),
            "a.shader:2:11: error: the shader \"A/Lit\" has no Pass named META: known are: FORWARD SHADOW" +
                line + "A/Lit/META\" } }\n              ^");
  EXPECT_EQ(why("A/Lot/META"),
            "a.shader:2:11: warning: UsePass needs the shader \"A/Lot\", which is not among those read: did "
            "you mean "
            "\"A/Lit\"?" +
                line + "A/Lot/META\" } }\n              ^");
  EXPECT_EQ(why("FORWARD"),
            "a.shader:2:11: error: UsePass \"FORWARD\" names no Pass: write \"Shader/Name/PASSNAME\"" + line +
                "FORWARD\" } }\n              ^");
  EXPECT_EQ(why("Chain/LOOP"),
            "a.shader:2:11: error: UsePass \"Chain/LOOP\" leads from UsePass to UsePass and never to a Pass" +
                line + "Chain/LOOP\" } }\n              ^");
}

TEST_F(UsePass, DoesNotFindPassesWithoutANameNorGrabPasses) {
  EXPECT_NE(why("A/Lit/GRAB").find("no Pass named GRAB"), std::string::npos);
  EXPECT_EQ(resolve("A/Lit/").pass, nullptr);
}

}  // namespace
}  // namespace penumbra::shaderlab
