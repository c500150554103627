// The scripts of `penumbra completion`, each in the shell that it is for.
#include "cli/program.h"

namespace penumbra {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class Completion : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    for (const char* shell_name : {"bash", "zsh", "fish"}) {
      const auto script = expect_success({"completion", shell_name});
      write(std::string("script.") + shell_name, script.output);
    }
    write("file.json", "{}");
    write("folder/inside.hlsl", "");
  }

  // The words that bash offers for the last of these.
  std::string in_bash(const std::string& words) const {
    return shell("cd " + path("").string() + "; source script.bash; COMP_WORDS=(penumbra " + words +
                 "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); COMP_LINE='penumbra " + words +
                 "'; COMP_POINT=${#COMP_LINE}; _penumbra; printf '%s\\n' \"${COMPREPLY[@]}\"")
        .output;
  }

  // The words of the line after a tab at its end, as an interactive bash completes it.
  std::string in_interactive_bash(const std::string& line) const {
    write("try.py", R"(import os, pty, sys
pid, terminal = pty.fork()
if pid == 0:
    os.environ.update(PS1="", TERM="dumb", INPUTRC="/dev/null", HISTFILE="/dev/null")
    os.execvp("bash", ["bash", "--norc", "--noprofile", "-i"])
os.write(terminal, b"source script.bash; penumbra() { printf '<%s>' \"$@\" >words; }; stty -echo\n")
os.write(terminal, b"penumbra " + sys.argv[1].encode() + b"\t\nexit\n")
try:
    while os.read(terminal, 4096): pass
except OSError: pass
os.waitpid(pid, 0)
)");
    const auto result = shell("cd " + path("").string() + "; rm -f words; timeout 60 python3 try.py '" +
                              line + "'; cat words");
    return result.output;
  }

  std::string in_fish(const std::string& line) const {
    const auto result =
        shell("cd " + path("").string() + "; HOME=" + path("").string() +
              " fish --no-config -c 'source script.fish; complete -C \"penumbra " + line + "\"'");
    EXPECT_EQ(result.errors, "");
    return result.output;
  }

  // The line of an interactive zsh after a tab, in brackets.
  std::string in_zsh(const std::string& line) const {
    write("try.zsh",
          "zmodload zsh/zpty; zpty -b shell zsh -f -i\n"
          "wait_for() { local all= part; while zpty -r -t shell part || sleep 0.05; do all+=$part;"
          " [[ $all != *$1* ]] || break; done; print -r -- $all }\n"
          "zpty -w shell 'autoload -Uz compinit; compinit -u -D; source script.zsh; PS1=; setopt no_beep; "
          "zstyle \":completion:*\" menu no; tell() { zle complete-word; print -r -- \"[$BUFFER]\" }; "
          "zle -N tell; bindkey \"^I\" tell; echo rea\"\"dy'\n"
          "wait_for ready >/dev/null\n"
          "zpty -w -n shell 'penumbra " +
              line +
              "'$'\\t'\n"
              "wait_for ']'\n");
    return shell("cd " + path("").string() + "; TERM=dumb COLUMNS=200 timeout 1500 zsh -f try.zsh").output;
  }
};

TEST_F(Completion, BashKnowsSubcommandsOptionsAndValues) {
  EXPECT_EQ(in_bash("mea"), "measure\n");
  EXPECT_EQ(in_bash("render --reference-"), "--reference-samples\n");
  EXPECT_EQ(in_bash("render --qui"), "--quiet\n");
  EXPECT_EQ(in_bash("tables --format cs"), "csharp\n");
  EXPECT_EQ(in_bash("-q tables --format cs"), "csharp\n");
  EXPECT_EQ(in_bash("measure --scene contact"), "contact-boxes\n");
  EXPECT_EQ(in_bash("measure --technique hard,tent-5-pl"), "hard,tent-5-plane\n");
  EXPECT_EQ(in_bash("validate --target ess"), "essl300\nessl310\n");
  EXPECT_EQ(in_bash("help cons"), "constants\n");
  EXPECT_EQ(in_bash("completion z"), "zsh\n");
}

TEST_F(Completion, BashKnowsFilesAndFolders) {
  EXPECT_EQ(in_bash("merge fi"), "file.json\n");
  EXPECT_EQ(in_bash("constants --config fi"), "file.json\n");
  EXPECT_EQ(in_bash("validate --project fo"), "folder\n");
  EXPECT_EQ(in_bash("validate --project fi"), "\n") << "no folder begins so";
  EXPECT_EQ(in_bash("constants --light fi"), "\n") << "a number is no file";
}

// At these two bash parts words by itself.
TEST_F(Completion, BashCompletesBehindColonsAndEqualsSigns) {
  write("a:file.obj", "");
  EXPECT_EQ(in_interactive_bash("measure --scene package:assimp/m"),
            "<measure><--scene><package:assimp/milk-truck>");
  EXPECT_EQ(in_interactive_bash("measure --scene package:gl"), "<measure><--scene><package:glmark2/>");
  EXPECT_EQ(in_interactive_bash("measure --scene trees,package:glmark2/b"),
            "<measure><--scene><trees,package:glmark2/bunny>");
  EXPECT_EQ(in_interactive_bash("measure --scene=ga"), "<measure><--scene=garden>");
  EXPECT_EQ(in_interactive_bash("measure --scene=trees,package:glmark2/b"),
            "<measure><--scene=trees,package:glmark2/bunny>");
  EXPECT_EQ(in_interactive_bash("measure --technique=hard,pcss-angular-64"),
            "<measure><--technique=hard,pcss-angular-64-64>");
  EXPECT_EQ(in_interactive_bash("constants --config=fi"), "<constants><--config=file.json>");
  EXPECT_EQ(in_interactive_bash("validate --project=fo"), "<validate><--project=folder/>");
  EXPECT_EQ(in_interactive_bash("measure --scene a:fi"), "<measure><--scene><a:file.obj>");
  EXPECT_EQ(in_interactive_bash("measure --light=2 --scene tre"), "<measure><--light=2><--scene><trees>");
  EXPECT_EQ(in_interactive_bash("measure -o out --scene colo"), "<measure><-o><out><--scene><colonnade>");
}

TEST_F(Completion, FishKnowsSubcommandsOptionsAndValues) {
  EXPECT_THAT(in_fish("mea"), HasSubstr("measure\t"));
  EXPECT_THAT(in_fish("render --reference-"), HasSubstr("--reference-samples\t"));
  EXPECT_THAT(in_fish("tables --format cs"), HasSubstr("csharp"));
  EXPECT_THAT(in_fish("measure --technique hard,tent-5-pl"), HasSubstr("hard,tent-5-plane"));
  EXPECT_THAT(in_fish("constants --config fi"), HasSubstr("file.json"));
  EXPECT_THAT(in_fish("validate --project fo"), AllOf(HasSubstr("folder"), Not(HasSubstr("file.json"))));
}

TEST_F(Completion, ZshKnowsSubcommandsOptionsAndValues) {
  EXPECT_THAT(in_zsh("mea"), HasSubstr("[penumbra measure ]"));
  EXPECT_THAT(in_zsh("render --reference-s"), HasSubstr("[penumbra render --reference-samples=]"));
  EXPECT_THAT(in_zsh("tables --format cs"), HasSubstr("[penumbra tables --format csharp ]"));
  EXPECT_THAT(in_zsh("measure --technique hard,pcss-angular-64-6"),
              HasSubstr("[penumbra measure --technique hard,pcss-angular-64-64 ]"));
  EXPECT_THAT(in_zsh("constants --config fil"), HasSubstr("[penumbra constants --config file.json ]"));
}

}  // namespace
}  // namespace penumbra
