// Tests sources that are hard to preprocess: the project's own preprocessor gives glslang's text, and leaves
// to it what it does not know.
#include <gtest/gtest.h>

#include <string>

#include "preprocessing/both_preprocessors.h"
#include "shaders/shader_files.h"
#include "shaders/source_memory.h"

namespace penumbra::preprocessing {
namespace {

struct Case {
  const char* name;
  const char* text;
};

void PrintTo(const Case& one, std::ostream* out) {
  *out << one.name;
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
  return info.param.name;
}

class ReadAlike : public testing::TestWithParam<Case> {};

TEST_P(ReadAlike, AsGlslangReadsIt) {
  const BothTexts both = both_texts(GetParam().text);
  EXPECT_FALSE(both.left_to_glslang);
  EXPECT_EQ(both.own, both.of_glslang);
  EXPECT_NE(both.of_glslang, "");
}

const Case read_alike[] = {
    {"Nothing", "\n"},
    {"Lines",
     "int a;\n\n\n  int b = 1 ;\n\tint c[ 2 ] = { 1 , 2 };\nfloat d = .5 + 1. + 1e5 + 1.5e-3f + 0x1Fu + "
     "017;\n"},
    {"Operators",
     "a<<=b>>=c<<d>>e<=f>=g==h!=i&&j||k^^l++--m+=n-=o*=p/=q%=r&=s|=t^=u::v:w?x:y~z!a%b^c&d|e.f<g>h;\n"},
    {"NumbersWithOddEnds", "float a = 3A + 0x1G + 1.xxx + 1..x + 2ul + 2L + 1.0half + 1.0lf;\n"},
    {"Texts", "a \"b // c /* \" d \"\" e;\n"},
    {"Comments", "a /* b */ c // d\n/* e\n f */ g /* h\n */ i;/**/j\n// k \\\n l\nm;\n"},
    {"JoinedLines", "a \\\n b \\\n\\\n  + c;\n#define D e \\\n  + f \\\n\nD\nint g = \\\n D;\n"},
    {"ObjectLike", "#define A b\n#define EMPTY\nA EMPTY A EMPTY\n  A\nEMPTY A\nx A\n"},
    {"CallAtLinesEnd", "#define A b\n#define F(x) x\nc A\nA\n  A\n  F(d)\nF(e) F(f)\n"},
    {"CallOnFirstLine", "A\n#define A b\nA\n"},
    {"CallOverLines", "#define F(x, y) [x] y\nF(a,\n  b) c\n  F\n  (\n 1\n,\n 2 ) d F(3, 4\n)\ne\n"},
    {"NameWithoutBrackets", "#define F(x) x + x\nint F; F + F(1) F\n ;\nG(F)(2)\n"},
    {"NestedNames",
     "#define F(x) G x\n#define G(x) x F\nF((1))(2) ;\n#define CALL(f, x) f(x)\nCALL(F, (3)) (4);\n"},
    {"EmptyArguments",
     "#define F(a, b) <a|b>\nF(,) F(1,) F(,2) F( , ) ;\n#define E\nF(E, E);\n#define N() n\nN() N( );\n"},
    {"CommasInBrackets",
     "#define F(a) a;\n#define G(a, b) a b\nF((1, 2)) G((1, 2), {3, 4}) G([1, 2]) F(({,}))\n"},
    {"SelfReference",
     "#define foo foo + 1\nfoo\n#define f(x) f(x + 1)\nf(f(2))\n#define g h\n#define h g\ng h\n#define p(x) "
     "q(x)\n"
     "#define q(x) p(x) + x\np(q(1)) q(p(p));\n"},
    {"SelfReferenceThroughArguments",
     "#define _Color ACCESS(Props, _Color)\n#define ACCESS(a, b) a##b + b\n#define ID(x) x\nID(_Color) "
     "ID(ID(_Color)) _Color\n"},
    // The example is the C standard's, 6.10.3.5, without # and without arguments that are left out.
    {"StandardExample3",
     "#define x 3\n#define f(a) f(x * (a))\n#undef x\n#define x 2\n#define g f\n#define z z[0]\n#define h "
     "g(~\n"
     "#define m(a) a(w)\n#define w 0,1\n#define t(a) a\n#define p() int\n#define q(x) x\n#define r(x, y) x "
     "## y\n"
     "f(y + 1) + f(f(z)) % t(t(g)(0) + t)(1);\ng(x + (3, 4) - w) | h 5) & m\n(f)^m(m);\np() i[q(1)] = { q(2) "
     "};\n"},
    {"StandardExample5",
     "#define t(x, y, z) x ## y ## z\nint j[] = { t(a, 1, 2), t(b, c, d), t(e, f, 3) };\n"},
    {"StandardExample7",
     "#define OBJ_LIKE (1-1)\n#define OBJ_LIKE /* white space */ (1-1) /* other */\n#define FUNC_LIKE(a) ( a "
     ")\n"
     "#define FUNC_LIKE( a )( /* note the white space */ \\\n a /* other stuff on this line\n*/ )\n"
     "FUNC_LIKE(OBJ_LIKE)\n"},
    {"PastingToNames",
     "#define JOIN(a, b) a##b\n#define JOIN2(a, b) a ## b\n#define AB 7\n#define A x\nJOIN(A, B) JOIN2(a, 1) "
     "JOIN(A, "
     "1B) JOIN(y, 1 2) JOIN(y, z w)\n#define T(n) sampler##n##_ST\nT(_MainTex) JOIN(JOIN(a, b), c)\n"
     "#define X JOIN(A, B) JOIN(AB, 3)\n"},
    {"PastingToCalls",
     "#define CALL(n, x) F_##n(x)\n#define F_a(x) (x + 1)\nCALL(a, CALL(a, 2))\n#define MAKE(n) "
     "M##n\n#define M1 2\n"
     "MAKE(1) MAKE(2)\n"},
    {"PastingOfNumbersFromMacros",
     "#define N  3\n#define J(a) x##a\n#define TWO y N\nJ(TWO) J(N) J(1.5f) J(0x1F)\n"},
    {"PastingInArguments",
     "#define ID(x) x\n#define P(a, b) ID(a ## b) ID(a##b c)\nP(q, r)\n#define K(x) ID(k##x)\nK(1) "
     "K(K(2))\n"},
    {"Definitions",
     "#define A 1\n#define A 1\n#define B(x,y)x+y\n#define B( x , y ) x+y\n#define C\n#define C\n#undef "
     "A\n#define A 2\n#undef "
     "NONE\nA B(1, 2) C\n"},
    {"Conditions",
     "#if 1\na\n#else\nb\n#endif\n#ifdef X\nc\n#elif defined(Y)\nd\n#else\ne\n#endif\n#ifndef "
     "X\nf\n#endif\n#if 0\n#elif "
     "1\ng\n#elif 1\nh\n#endif\n#if 0\n#endif\ni\n"},
    {"ConditionsInSkippedText",
     "#if 0\n#if 1\na\n#else\nb\n#endif\n#ifdef\n#if (\n#elif )\n#endif\n#endif\n#foo\n# 1\n#error "
     "no\n#define\n#include "
     "\"none\"\n#version 3\n#pragma x\n@ $\n#else\nc\n#endif\n"},
    {"Arithmetic",
     "#define V (3)\n#if V * 2 + 1 == 7 && -1 < 0 && ~0 == -1 && !0 && (1 << 4) == 0x10 && 7 / 2 == 3 && -7 "
     "% 4 == -3 && "
     "017 == 15\na\n#endif\n#if 1 - 2 - 3 == -4 && 2 | 1 ^ 1 & 0\nb\n#endif\n#if 4294967295 == -1 && "
     "2147483647 + 1 < 0\nc\n"
     "#endif\n#if 5 > 4 > 3\nd\n#else\ne\n#endif\n#if UNKNOWN == 0 || UNKNOWN2\nf\n#endif\n#if (1 || 0) && "
     "(0 || 0)\ng\n#endif\n"},
    {"MacrosInConditions",
     "#define F(x, y) (x > y)\n#define D defined(E)\n#define EMPTY\n#if F(2, 1) && !D\na\n#endif\n#define E "
     "0\n#if D && EMPTY "
     "E == 0 EMPTY\nb\n#endif\n#define S S\n#if defined S && "
     "defined ( AB "
     ")\nd\n#endif\n"},
    {"WholeFloatsInConditions", "#if 1\nfloat a = 1f + 2h;\n#endif\n"},
    {"BlanksOfDirectives", "  #  define A(x)   x\n#\n # if  A( 1 )  // c\n  A ( 2 )\n#\tendif /* d */\n"},
    {"CommentsInDirectives", "#define A /* b\n c */ d\nA\n#if /* e\n*/ 1 // f \\\n g\nA\n#endif\n"},
    {"LongIntegers",
     "#define A 0x1376312589U\nuint a = A + 5000000000u;\n#if 0x100000001L == 1\nb\n#endif\n"},
    {"KeywordsAsNames", "#define if 1\n#define define 2\nif define else include\n"},
    {"NameThatGlslangDefines",
     "#ifdef VULKAN\na\n#endif\nint VULKAN;\n#define VULKAN 7\n#ifdef VULKAN\nb VULKAN\n#endif\n"},
    {"Depth", "#if 1\n#if 1\n#if 0\n#elif 1\n#ifdef A\n#else\na\n#endif\n#endif\n#endif\n#endif\nb\n"},
};

INSTANTIATE_TEST_SUITE_P(Preprocessor, ReadAlike, testing::ValuesIn(read_alike), name_of);

class LeftToGlslang : public testing::TestWithParam<Case> {};

TEST_P(LeftToGlslang, WithItsMessagesAndItsText) {
  const BothTexts both = both_texts(GetParam().text);
  EXPECT_TRUE(both.left_to_glslang);
  EXPECT_EQ(both.own, both.of_glslang);
}

const Case left_to_glslang[] = {
    {"TwoDefinitions", "#define A 1\n#define A 2\nA\n"},
    {"BlanksThatDiffer", "#define A 1+2\n#define A 1 + 2\nA\n"},
    {"ParametersThatDiffer", "#define A(x) x\n#define A(y) y\nA(1)\n"},
    {"TooFewArguments", "#define F(a, b) a b\nF(1)\n"},
    {"TooManyArguments", "#define F(a) a\nF(1, 2)\n"},
    {"NoArgument", "#define F(a) a\nF()\n"},
    {"ArgumentsOfNone", "#define F() a\nF(1)\n"},
    {"ArgumentsThatExpandToSeveral", "#define F(a, b) a b\n#define P 1, 2\nF(P)\n"},
    {"CallThatDoesNotEnd", "#define F(a) a\nF(1\n"},
    {"CallOverADirective", "#define F(a) a\nF(1\n#define B\n)\n"},
    {"NameBeforeADirective", "#define F(a) a\nF\n#define B\n"},
    {"NameAtTheEnd", "#define F(a) a\nF\n"},
    {"Strings", "#define F(a) #a\nF(1)\n"},
    {"HashInText", "a # b\n"},
    {"HashAsArgument", "#define F(a) a\nF(#)\n"},
    {"PasteFirst", "#define A ## b\nA\n"},
    {"PasteLast", "#define A b ##\nA\n"},
    {"PasteOfNothing", "#define F(a) a ## b\nF()\n#define G(a, c) a##c\nG(, d)\n"},
    {"PasteOfOperators", "#define A < ## <\nA\n"},
    {"PasteOfNumbers", "#define F(a) 1 ## a\nF(2)\n"},
    {"LineNumber", "__LINE__\n"},
    {"LineDirective", "#line 7\na\n"},
    {"Version", "#version 450\n"},
    {"Error", "#error no\n"},
    {"UnknownDirective", "#foo\n"},
    {"NumberAsDirective", "# 1\n"},
    {"UnbalancedEnd", "#endif\n"},
    {"UnbalancedIf", "#if 1\n"},
    {"TwoElse", "#if 0\n#else\n#else\n#endif\n"},
    {"ElifAfterElse", "#if 0\n#else\n#elif 1\n#endif\n"},
    {"ElseBehindTwoHashes", "#if 0\na\n##else\nb\n#endif\n"},
    {"MoreAfterElse", "#if 0\n#else x\n#endif\n"},
    {"MoreAfterIfdef", "#ifdef A B\n#endif\n"},
    {"MoreAfterUndef", "#undef A B\n"},
    {"DivisionByZero", "#if 1 / 0\n#endif\n"},
    {"DivisionByZeroBehindOr", "#if 1 || 1 % 0\na\n#endif\n"},
    {"WideShift", "#if 1 << 32\na\n#endif\n"},
    {"UnsignedCondition", "#if 1u\na\n#endif\n"},
    {"FloatCondition", "#if 1.0\na\n#endif\n"},
    {"EmptyCondition", "#if\na\n#endif\n"},
    {"PasteInCondition", "#define N A##B\n#if N\n#endif\n"},
    {"OpenBracketInCondition", "#if (1\na\n#endif\n"},
    {"CallWithoutBracketsInCondition", "#define F(x) x\n#if F\n#endif\n"},
    {"WholeFloat", "float a = 1f;\n"},
    {"WholeFloatInDefinition", "#define A 1h2\n"},
    {"Apostrophe", "a ' b\n"},
    {"ApostropheInSkippedText", "#if 0\ndon't\n#endif\n"},
    {"Backslash", "a \\ b\n"},
    {"EscapeInText", "a \"\\n\";\n"},
    {"TextThatDoesNotEnd", "a \"b\n"},
    {"CommentThatDoesNotEnd", "a /* b\n"},
    {"BadCharacter", "a @ b\n"},
    {"BadCharacterInDefinition", "#define A \xC3\xA4\nA\n"},
    {"BadExponent", "1e;\n"},
    {"BadOctal", "08;\n"},
    {"WideNumber", "4294967296;\n"},
    {"JoinedInFirstColumn", "#define A b\nA\\\nc\n"},
    {"JoinedRightBehindAMacro", "#define A b\n+A\\\n.c\n"},
    {"JoinedRightBehindAnArgument", "#define F(x) x\n#define A F\n#define B b\n+A B\\\n.c\n"},
    {"NameOverJoinedLines", "ab\\\ncd\n"},
    {"DefinitionOfDefined", "#define defined 1\n"},
    {"DefinitionWithoutBlank", "#define A-1\nA\n"},
    {"DefinitionWithSameParameters", "#define A(x, x) x\nA(1, 2)\n"},
    {"IncludeOfAMacro", "#define A \"b\"\n#include A\n"},
    {"IncludeOfNothing", "#include \"none.hlsl\"\n"},
};

INSTANTIATE_TEST_SUITE_P(Preprocessor, LeftToGlslang, testing::ValuesIn(left_to_glslang), name_of);

TEST(Preprocessor, ReadsIncludesAsGlslangDoes) {
  const shaders::ShaderFiles files;
  files.write("a.hlsl", "#ifndef A\n#define A\nint a;\n#include \"sub/b.hlsl\"\n  int a2; B(1)\n#endif");
  files.write("sub/b.hlsl",
              "int b; int b2;\n#include <c.hlsl>\n#include \"c.hlsl\"\n#define B(x) \\\n b##x\n");
  files.write("sub/c.hlsl", "   first\n\n\nB2;");
  files.write("empty.hlsl", "");
  files.write("once.hlsl", "#pragma once\nonce\n");
  files.write("main.hlsl",
              "#define B2 b3\n  #include \"a.hlsl\"\nx\n#include \"a.hlsl\"\n\n#include \"empty.hlsl\"\n"
              "#include \"once.hlsl\"\n#include \"once.hlsl\"\n#include \"sub/c.hlsl\" // again\ny\n");
  shaders::CompileRequest request = files.request("main.hlsl");
  request.prepare = true;
  request.defines = {{"FIRST", "1"}, {"SECOND(x)", "x"}};
  const BothTexts both = both_texts(request);
  EXPECT_FALSE(both.left_to_glslang);
  EXPECT_EQ(both.own, both.of_glslang);
  EXPECT_NE(both.own.find("b1"), std::string::npos);
}

TEST(Preprocessor, KnowsNoExtensionsOfGlsl) {
  const BothTexts both = both_texts("#ifdef GL_EXT_multiview\na\n#endif\nb\n");
  EXPECT_FALSE(both.left_to_glslang);
  EXPECT_EQ(both.own, "\n\n\nb\n");
}

// A call that begins in an included file does not end in the one that includes it.
TEST(Preprocessor, LeavesCallsThatEndInAnotherFile) {
  const shaders::ShaderFiles files;
  files.write("a.hlsl", "F(1\n");
  files.write("main.hlsl", "#define F(x) x\n#include \"a.hlsl\"\n)\n");
  shaders::CompileRequest request = files.request("main.hlsl");
  request.prepare = true;
  const BothTexts both = both_texts(request);
  EXPECT_TRUE(both.left_to_glslang);
  EXPECT_EQ(both.own, both.of_glslang);
}

// What one reading defines is no longer defined in the next, whichever way the first ended.
TEST(Preprocessor, ForgetsBetweenReadings) {
  shaders::SourceMemory memory;
  shaders::CompileRequest request;
  request.file = "main.hlsl";
  request.prepare = true;
  request.text = "#define A b\nA\n";
  EXPECT_EQ(shaders::expand(request, memory).text, "\n b\n");
  request.text = "A\n";
  EXPECT_EQ(shaders::expand(request, memory).text, "A\n");
  request.text = "#define A(x) x\nA(A(\n";
  EXPECT_EQ(shaders::expand(request, memory).text, "");
  EXPECT_EQ(memory.left_to_glslang(), 1U);
  request.text = "A(1)\n";
  EXPECT_EQ(shaders::expand(request, memory).text, "A(1)\n");
  EXPECT_EQ(memory.left_to_glslang(), 1U);
}

}  // namespace
}  // namespace penumbra::preprocessing
