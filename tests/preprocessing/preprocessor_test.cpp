// Tests sources that are hard to preprocess. The answers are the C standard's (6.10.3), and where a comment
// says so, what D3DPreprocess of FXC 10.0.26100 gives.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "preprocessing/read_text.h"
#include "shaders/shader_files.h"
#include "shaders/source_memory.h"

namespace penumbra::preprocessing {
namespace {

struct Case {
  const char* name;
  const char* text;
  const char* expected;
};

void PrintTo(const Case& one, std::ostream* out) {
  *out << one.name;
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
  return info.param.name;
}

// White space becomes one blank between words, and none at the ends.
std::string in_one_line(const std::string& text) {
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

class Reads : public testing::TestWithParam<Case> {};

TEST_P(Reads, AsExpected) {
  EXPECT_EQ(in_one_line(read_text(GetParam().text)), GetParam().expected);
}

const Case texts[] = {
    {"Nothing", "\n", ""},
    {"Operators", "a<<=b>>=c<<d>>e::f?g:h^^i\n", "a <<= b >>= c << d >> e :: f ? g : h ^^ i"},
    {"Numbers", "3A + 0x1G + 1.xxx + 1..x + 2ul + 1.5e-3f + .5\n",
     "3 A + 0x1 G + 1. xxx + 1. . x + 2ul + 1.5e-3f + .5"},  // as FXC splits them
    {"Texts", "a \"b // c /* \\\" d\" \"\" e;\n", "a \"b // c /* \\\" d\" \"\" e;"},
    {"Comments", "a /* b */ c // d\n/* e\n f */ g /* h\n */ i;/**/j\n// k \\\n l\nm;\n", "a c g i;j m;"},
    {"JoinedLines", "a \\\n b \\\n\\\n  + c;\n#define D e \\\n  + f \\\n\nD\n", "a b + c; e + f"},
    {"JoinedNames", "ab\\\ncd\n", "ab cd"},  // as FXC reads it, not as C does
    {"ObjectLike", "#define A b\n#define EMPTY\nA EMPTY A\n  A\nEMPTY x A\n", "b b b x b"},
    {"CallOverLines", "#define F(x, y) [x] y\nF(a,\n  b) c\n  F\n  (\n 1\n,\n 2 ) d\n", "[a]b c [1]2 d"},
    {"CallOverDirectives",  // as in FXC
     "#define F(a, b) <a|b>\n#define X\nF(1,\n#define B 7\n#ifdef X\n 2\n#else\n 3\n#endif\n+ B)\n",
     "< 1 | 2 + 7 >"},
    {"NameWithoutBrackets", "#define F(x) x + x\nint F; F + F(1) F\n ;\n", "int F;F + 1 + 1 F ;"},
    {"NameBeforeADirective", "#define F(a) a\nF\n#define B\n(3)\n", "F (3)"},
    {"NestedNames", "#define A(x) x B\n#define B(x) x\nA(1)(2)\n", "1 2"},
    {"EmptyArguments",
     "#define F(a, b) <a|b>\nF(,) F(1,) F(,2)\n#define N() n\nN() N( )\n#define G(a) [a]\nG()\n",
     "< | > < 1 | > < | 2 > n n []"},
    {"CommasInBrackets",  // as in FXC
     "#define F(a) a;\n#define G(a, b) a b\nF((1, 2)) G((1, 2), {3, 4}) F(x[1, 2]) F({1,2})\n",
     "(1, 2);(1, 2){ 3, 4 } x[1, 2];{ 1, 2 };"},
    {"SelfReference",
     "#define foo foo + 1\nfoo\n#define f(x) f(x + 1)\nf(f(2))\n#define g h\n#define h g\ng h\n",
     "foo + 1 f(f(2 + 1)+ 1) g h"},
    {"SelfReferenceThroughArguments",
     "#define ACCESS(arr, var) arr##Array[id].var\n#define _Color ACCESS(Props, _Color)\n#define ID(x) x\n"
     "ID(ID(_Color)) _Color\n",
     "PropsArray[id]. _Color PropsArray[id]. _Color"},
    {"StandardExample3",
     "#define x 3\n#define f(a) f(x * (a))\n#undef x\n#define x 2\n#define g f\n#define z z[0]\n"
     "#define h g(~\n#define m(a) a(w)\n#define w 0,1\n#define t(a) a\n#define p() int\n#define q(x) x\n"
     "f(y + 1) + f(f(z)) % t(t(g)(0) + t)(1);\ng(x + (3, 4) - w) | h 5) & m\n(f)^m(m);\np() i[q(1)]\n",
     "f(2 *(y + 1))+ f(2 *(f(2 *(z[0]))))% f(2 *(0))+ t(1); f(2 *(2 +(3, 4)- 0, 1))| f(2 *(~ 5))& f(2 *(0, "
     "1))^ m(0, 1); int i[1]"},
    {"Texts6_10_3_2", "#define str(s) # s\nstr(a  \"b\" /* c */ d)\n", "\"a \"b\" d\""},
    {"StandardExample5",
     "#define t(x,y,z) x ## y ## z\n{ t(a,1,2), t(,b,c), t(d,,e), t(f,g,), t(h,,), t(,,) }\n",
     "{ a12, bc, de, fg, h, }"},
    {"Pasting",
     "#define J(a, b) a ## b\n#define AB 7\n"
     "J(A, B) J(a, 1) J(Texture, 2D) J(y, 1 2) J(1, 2) J(x, .y) J(<, <)\n",
     "7 a1 Texture2D y1 2 12 x . y <<"},
    {"PastingOfExpandedArguments",  // as FXC does it, not as C does
     "#define X Y\n#define J(a, b) a##b\nJ(X, X) J(x, X z)\n", "YY xY z"},
    {"PastingToCalls", "#define CALL(n, x) F_##n(x)\n#define F_a(x) (x + 1)\nCALL(a, CALL(a, 2))\n",
     "((2 + 1)+ 1)"},
    {"PastingWithoutOperands", "#define A ## b\n#define B c ##\nA B d\n", "b c d"},
    {"ArgumentsThatExpandToSeveral",  // as in FXC, where the call alone has too few
     "#define SAMPLE(map, uv, slice) map(uv, slice)\n#define ALIAS SAMPLE\n#define UV uv, 3\n"
     "#define MORE , 4\nSAMPLE(m, UV) ALIAS(m, st MORE) SAMPLE(m, f(UV), 1)\n",
     "m(uv, 3)m(st, 4)m(f(uv, 3), 1)"},
    {"Definitions", "#define B(x,y)x+y\n#undef A\n#define A-1\n#undef NONE\nA B(1, 2)\n", "- 1 1 + 2"},
    {"LaterDefinition", "#define A 1\nA\n#define A 2\nA\n", "1 2"},
    {"LineNumbers", "a\n__LINE__\n\n#define L __LINE__\nL\n", "a 2 5"},
    {"Conditions",
     "#if 1\na\n#else\nb\n#endif\n#ifdef X\nc\n#elif defined(Y)\nd\n#else\ne\n#endif\n#ifndef X\nf\n#endif\n"
     "#if 0\n#elif 1\ng\n#elif 1\nh\n#endif\n",
     "a e f g"},
    {"SkippedText",
     "#if 0\n#if 1\na\n#else\nb\n#endif\n#ifdef\n#if (\n#elif )\n#endif\n#endif\n#foo\n# 1\n#error no\n"
     "#define\n#include \"none\"\n##else\n@ $ don't \"\n#else more\nc\n#endif\n",
     "c"},
    {"BranchesThatAreNotReached", "#if 1\na\n#elif (\nb\n#endif\n", "a"},
    {"Arithmetic",
     "#define V (3)\n#if V * 2 + 1 == 7 && -1 < 0 && ~0 == -1 && !0 && (1 << 4) == 0x10 && 7 / 2 == 3 && "
     "-7 % 4 == -3 && 017 == 15\na\n#endif\n#if 1 - 2 - 3 == -4 && 2 | 1 ^ 1 & 0\nb\n#endif\n"
     "#if 5 > 4 > 3\nd\n#else\ne\n#endif\n#if UNKNOWN == 0\nf\n#endif\n#if 1u && 10L == 10\ng\n#endif\n"
     "#if 1 ? 0 : 1\nh\n#endif\n",
     "a b e f g"},
    {"UnsignedArithmetic",
     "#if 0xFFFFFFFF > 0 && 2147483648 > 0 && -1 > 1u && (0u - 1) > 0 && !(1u - 2 < 0) && -8 >> 1 == -4\na\n"
     "#endif\n#if 4294967295 == -1 && -1 / 2u == 0x7FFFFFFF && (1 ? -1 : 0u) > 0\nb\n#endif\n",
     "a b"},
    {"LineOfACondition", "#define L __LINE__\nint a = L;\n\n#if __LINE__ == 4 && L == 4\nb\n#endif\n",
     "int a = 2; b"},
    {"TextsOverLines", "#define M \"a\\\n b\"\nM c\n", "\"a\\ b\" c"},
    {"MoreAfterEndif", "#if 1\na\n#endif of it\nb\n", "a b"},
    {"BracketsThatAreNotClosed", "#define F(a) <a>\nF([) ]\n", "<[>]"},  // as in FXC
    {"DivisionThatIsNotReached", "#if 1 || 1 % 0\na\n#endif\n#if 0 && 1 / 0\n#else\nb\n#endif\n", "a b"},
    {"MacrosInConditions",
     "#define F(x, y) (x > y)\n#define D defined(E)\n#define EMPTY\n#if F(2, 1) && !D\na\n#endif\n"
     "#define E 0\n#if D && EMPTY E == 0 EMPTY\nb\n#endif\n#if defined ( E ) && defined D\nc\n#endif\n",
     "a b c"},
    {"CommentsInDirectives", "#define A /* b\n c */ d\nA\n#if /* e\n*/ 1 // f \\\n g\nA\n#endif\n", "d d"},
    {"DirectivesWithoutEffect", "#\n#pragma multi_compile _ A\n#warning no\n#line 7 \"x\"\na __LINE__\n",
     "a 5"},
};

INSTANTIATE_TEST_SUITE_P(Preprocessor, Reads, testing::ValuesIn(texts), name_of);

// The places are lines and columns.
const Case errors[] = {
    {"TooFewArguments", "#define F(a, b) a b\n F(1)\n", "2:2: too few arguments for macro 'F'"},
    {"TooManyArguments", "#define F(a) a\nF(1, 2)\n", "2:1: too many arguments for macro 'F'"},
    {"ArgumentsOfNone", "#define F() a\nF(1)\n", "2:1: too many arguments for macro 'F'"},
    {"TooManyAfterAll", "#define F(a, b) a b\n#define P 1, 2\nF(0, P, 3)\n",
     "3:1: too many arguments for macro 'F'"},
    {"CallThatDoesNotEnd", "#define F(a) a\nx F(1\n", "2:3: the call of macro 'F' is never closed"},
    {"IncludeInACall", "#define F(a) a\nF(1\n#include \"b\"\n)\n", "3:1: #include among a macro's arguments"},
    {"HashInText", "a # b\n", "1:3: unexpected token '#'"},
    {"HashInAMacro", "#define A x # y\nb A\n", "2:3: unexpected token '#'"},
    {"Error", "a\n  #error  no \"x\n", "2:3: '#error': no \"x"},
    {"UnknownDirective", "#foo\n", "1:1: unknown directive '#foo'"},
    {"Version", "#version 450\n", "1:1: unknown directive '#version'"},
    {"EndWithoutIf", "a\n#endif\n", "2:1: '#endif' has no '#if' in this file"},
    {"IfWithoutEnd", "#if 1\n #ifdef A\n", "2:2: '#ifdef' has no '#endif' in this file"},
    {"TwoElse", "#if 0\n#else\n#else\n#endif\n", "3:1: '#else' comes after another '#else'"},
    {"ElifAfterElse", "#if 0\n#else\n#elif 1\n#endif\n", "3:1: '#elif' comes after '#else'"},
    {"MoreAfterIfdef", "#ifdef A B\n#endif\n", "1:1: '#ifdef' takes the name of one macro"},
    {"NothingAfterIfndef", "#ifndef\n#endif\n", "1:1: '#ifndef' takes the name of one macro"},
    {"MoreAfterUndef", "#undef A B\n", "1:1: '#undef' takes the name of one macro"},
    {"DivisionByZero", "#if 1 / 0\n#endif\n", "1:1: in this condition: division by 0"},
    {"WideShift", "#if 1 << 32\n#endif\n", "1:1: in this condition: a shift by less than 0 or more than 31"},
    {"FloatCondition", "#if 1.0\n#endif\n", "1:1: this condition has no value: unexpected '1.0'"},
    {"EmptyCondition", "#if\n#endif\n", "1:1: this condition has no value"},
    {"OpenBracket", "#if (1\n#endif\n", "1:1: in this condition: '(' is never closed"},
    {"MoreAfterTheCondition", "#if 1 2\n#endif\n", "1:1: the condition ends before its line does, at '2'"},
    {"ElifWithoutValue", "#if 0\n#elif\n#endif\n", "2:1: this condition has no value"},
    {"DefinedOfNothing", "#if defined\n#endif\n", "1:1: 'defined' takes the name of a macro"},
    {"Apostrophe", "a ' b\n", "1:3: unexpected token '''"},
    {"Backslash", "a \\ b\n", "1:3: '\\' may only end a line"},
    {"TextThatDoesNotEnd", "a \"b\n", "1:3: this text has no closing '\"' on its line"},
    {"CommentThatDoesNotEnd", "a\n /* b\n", "2:2: '/*' is never closed"},
    {"BadCharacter", "a @ b\n", "1:3: unexpected token '@'"},
    {"BadCharacterInAMacro", "#define A \xC3\xA4\nb A\n", "2:3: unexpected token '\xC3\xA4'"},
    {"BadByte", "a\xF6 b\n", "1:2: unexpected byte 0xF6; is this file UTF-8?"},
    {"DefinitionOfNothing", "#define\n", "1:1: '#define' names no macro"},
    {"DefinitionOfDefined", "#define defined 1\n", "1:1: 'defined' cannot be the name of a macro"},
    {"SameParameters", "#define A(x, x) x\n", "1:1: two parameters of this macro are called 'x'"},
    {"OpenParameters", "#define A(x\n", "1:1: the parameters of macro 'A' are not closed by ')'"},
    {"AnyArguments", "#define A(x, ...) x\n",
     "1:1: not supported here: macros with '...'; name the parameters, and write a macro for each number of "
     "arguments"},
    {"IncludeOfAMacro", "#define A \"b\"\n#include A\n", "2:1: '#include' needs a \"file\" or a <file>"},
    {"IncludeWithoutEnd", "#include \"b\n", "1:1: this '#include' has no closing '\"'"},
    {"IncludeOfNothing", "a\n#include \"none.hlsl\"\n", "2:1: 'none.hlsl' is not there"},
};

INSTANTIATE_TEST_SUITE_P(PreprocessorErrors, Reads, testing::ValuesIn(errors), name_of);

TEST(Preprocessor, EndsHugeExpansions) {
  std::string text = "#define A0 x x\n";
  for (int i = 1; i < 40; ++i)
    text +=
        "#define A" + std::to_string(i) + " A" + std::to_string(i - 1) + " A" + std::to_string(i - 1) + "\n";
  EXPECT_EQ(read_text(text + "A39\n"), "41:1: a macro expansion that is too large");
  std::string nested = "#define F(x) x\n";
  for (int i = 0; i < 1200; ++i) nested += "F(";
  EXPECT_THAT(read_text(nested + "1" + std::string(1200, ')') + "\n"),
              testing::EndsWith("macro calls nested too deeply"));
  std::string doubled = "x";
  for (int i = 0; i < 30; ++i) doubled = "P(" + doubled + ")";
  EXPECT_THAT(read_text("#define P(a) a##a\n" + doubled + "\n"), testing::EndsWith("of more than 64 KiB"));
  EXPECT_EQ(read_text("#if " + std::string(5000, '(') + "\n#endif\n"),
            "1:1: in this condition: brackets nested too deeply");
}

std::string messages_of(const std::vector<hlsl::Diagnostic>& diagnostics) {
  std::string text;
  for (const hlsl::Diagnostic& said : diagnostics) text += format(said) + "\n";
  return text;
}

TEST(Preprocessor, FollowsIncludes) {
  const shaders::ShaderFiles files;
  files.write("a.hlsl", "#ifndef A\n#define A\nint a;\n#include \"sub/b.hlsl\"\n  int a2; B(1)\n#endif");
  files.write("sub/b.hlsl", "int b;\n#include <c.hlsl>\n#include \"c.hlsl\"\n#define B(x) \\\n b##x\n");
  files.write("sub/c.hlsl", "   first\n\n\nB2;");
  files.write("empty.hlsl", "");
  files.write("once.hlsl", "  # pragma once // here\nonce\n#if 0\n#pragma once\n#endif\n");
  files.write("twice.hlsl", "#if 0\n#pragma once\n#endif\ntwice\n");
  files.write("main.hlsl",
              "#define B2 b3\n  #include \"a.hlsl\"\nx\n#include \"a.hlsl\"\n#include \"empty.hlsl\"\n"
              "#include_with_pragmas \"once.hlsl\"\n#include /* c */ \"once.hlsl\"\ny\n"
              "#include \"twice.hlsl\"\n#include \"twice.hlsl\"\n");
  shaders::CompileRequest request = files.request("main.hlsl");
  request.defines = {{"FIRST", "1"}, {"SECOND(x)", "x"}};
  shaders::SourceMemory memory;
  const shaders::PreprocessedSource read = shaders::expand(request, memory);
  EXPECT_EQ(messages_of(read.diagnostics), "");
  std::string text = read.text;
  const std::string folder = files.path("").string();
  for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder))
    text.erase(at, folder.size());
  EXPECT_EQ(text,
            "#line 3 \"a.hlsl\"\nint a;\n#line 1 \"sub/b.hlsl\"\nint b;\n#line 1 \"sub/c.hlsl\"\n"
            "   first\n\n\nb3;\n#line 1 \"sub/c.hlsl\"\n   first\n\n\nb3;\n#line 5 \"a.hlsl\"\n"
            "  int a2;b1\n#line 3 \"main.hlsl\"\nx\n#line 2 \"once.hlsl\"\nonce\n#line 8 \"main.hlsl\"\ny\n"
            "#line 4 \"twice.hlsl\"\ntwice twice\n");
}

TEST(Preprocessor, SaysWhereAnIncludedFileIsWrong) {
  const shaders::ShaderFiles files;
  files.write("a.hlsl", "int a;\n#if X\n");
  files.write("main.hlsl", "#include \"a.hlsl\"\n");
  shaders::SourceMemory memory;
  const shaders::PreprocessedSource read = shaders::expand(files.request("main.hlsl"), memory);
  EXPECT_EQ(read.text, "");
  EXPECT_EQ(
      messages_of(read.diagnostics),
      files.path("a.hlsl").string() + ":2:1: error: '#if' has no '#endif' in this file\n    #if X\n    ^\n");
}

TEST(Preprocessor, WarnsOfASecondDefinition) {
  shaders::CompileRequest request;
  request.file = "main.hlsl";
  request.defines = {{"QUALITY", "1"}};
  request.text =
      "#define QUALITY 2\n#define A(x) x\n#define A(x)  x\n#define A(y) y * 2\n#undef A\n#define A\n";
  shaders::SourceMemory memory;
  std::vector<std::string> said;
  for (const hlsl::Diagnostic& one : shaders::expand(request, memory).diagnostics)
    said.push_back(std::to_string(one.line) + ":" + std::to_string(one.column) + ": " + one.message);
  EXPECT_EQ(said, (std::vector<std::string>{
                      "1:9: macro 'QUALITY' is defined as something else before the first line; from here on "
                      "this definition is used",
                      "4:9: macro 'A' is defined as something else at main.hlsl:3; from here on this "
                      "definition is used"}));
}

// What one reading defines is no longer defined in the next, whichever way the first ended.
TEST(Preprocessor, ForgetsBetweenReadings) {
  shaders::SourceMemory memory;
  shaders::CompileRequest request;
  request.file = "main.hlsl";
  request.text = "#define A b\nA\n";
  EXPECT_EQ(shaders::expand(request, memory).text, "\nb\n");
  request.text = "A\n";
  EXPECT_EQ(shaders::expand(request, memory).text, "A\n");
  request.text = "#define A(x) x\nA(A(\n";
  EXPECT_EQ(shaders::expand(request, memory).text, "");
  request.text = "A(1)\n";
  EXPECT_EQ(shaders::expand(request, memory).text, "A(1)\n");
}

}  // namespace
}  // namespace penumbra::preprocessing
