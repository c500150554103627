using System;
using System.Collections.Generic;
using System.Linq;

namespace Penumbra.Editor
{
    /// <summary>How a shader takes the main light's shadow.</summary>
    public enum ReceiverKind
    {
        /// <summary>Names no main light shadow keyword: it takes no shadow, or by an include that names them.</summary>
        None,

        /// <summary>Reads the screen-space texture where it is asked to.</summary>
        Complete,

        /// <summary>A program lacks the screen keyword: its surfaces lose their shadow while the feature is on.</summary>
        LacksScreen,
    }

    /// <summary>
    /// Finds the programs of a shader's text whose pragmas name URP's main light shadow keywords, and adds the one that
    /// is missing. A program is all between HLSLPROGRAM and ENDHLSL (or CG's words) with the HLSLINCLUDE blocks of the
    /// file, and an include file as a whole. A pragma is read as a line; what stands in comments is left alone.
    /// </summary>
    internal static class ReceiverPragma
    {
        internal static ReceiverKind KindOf(string text)
        {
            List<Line[]> receivers = Receivers(text);
            if (receivers.Count == 0) return ReceiverKind.None;
            return receivers.All(HasScreen) ? ReceiverKind.Complete : ReceiverKind.LacksScreen;
        }

        /// <summary>
        /// The text with the keyword once in every program that lacks it, at the end of the pragma of the cascades or
        /// else of the map; line ends stay as they are.
        /// </summary>
        internal static string WithScreen(string text)
        {
            var lacking = new SortedSet<int>();
            foreach (Line[] program in Receivers(text))
            {
                if (HasScreen(program)) continue;
                Line pragma = Array.Find(program, one => one.Names(ShadowKeywords.CascadesName)) ??
                                Array.Find(program, one => one.Names(ShadowKeywords.MapName));
                pragma.addsScreen = true;  // a block of all programs gives it to the next ones too
                lacking.Add(pragma.end);
            }
            foreach (int end in lacking.Reverse()) text = text.Insert(end, " " + ShadowKeywords.ScreenName);
            return text;
        }

        // By program its pragmas of variants, of those programs that name the keyword of a map.
        private static List<Line[]> Receivers(string text)
        {
            var outside = new List<Line>();  // of an include file, all there is
            var shared = new List<Line>();
            var programs = new List<List<Line>>();
            List<Line> block = outside;
            foreach (Line line in Lines(text))
            {
                if (line.Opens("PROGRAM")) programs.Add(block = new List<Line>());
                else if (line.Opens("INCLUDE")) block = shared;
                else if (line.Names("ENDHLSL") || line.Names("ENDCG")) block = outside;
                else if (line.IsOfVariants) block.Add(line);
            }
            programs.Add(outside);
            return programs.Select(own => own == outside ? own.ToArray() : own.Concat(shared).ToArray())
                .Where(program => program.Any(pragma => pragma.NamesMap)).ToList();
        }

        private static bool HasScreen(Line[] program) =>
            Array.Exists(program, pragma => pragma.addsScreen || pragma.Names(ShadowKeywords.ScreenName));

        private sealed class Line
        {
            internal string[] words;
            internal int end;  // behind its last word
            internal bool addsScreen;

            internal bool Names(string word) => Array.IndexOf(words, word) >= 0;

            internal bool NamesMap => Names(ShadowKeywords.MapName) || Names(ShadowKeywords.CascadesName);

            internal bool Opens(string what) => Names("HLSL" + what) || Names("CG" + what);

            internal bool IsOfVariants =>
                words.Length > 1 && words[0] == "#pragma" &&
                (words[1].StartsWith("multi_compile", StringComparison.Ordinal) ||
                 words[1].StartsWith("shader_feature", StringComparison.Ordinal));
        }

        private static IEnumerable<Line> Lines(string text)
        {
            bool inComment = false;
            for (int start = 0; start < text.Length;)
            {
                int newline = text.IndexOf('\n', start);
                int end = newline < 0 ? text.Length : newline;
                string code = WithoutComments(text.Substring(start, end - start), ref inComment).TrimEnd();
                yield return new Line
                {
                    words = code.Split(new[] { ' ', '\t' }, StringSplitOptions.RemoveEmptyEntries),
                    end = start + code.Length,
                };
                start = end + 1;
            }
        }

        // As long as it was up to the end of the code: comments between become blanks.
        private static string WithoutComments(string line, ref bool inComment)
        {
            char[] code = line.ToCharArray();
            for (int at = 0; at < code.Length; ++at)
            {
                if (inComment)
                {
                    bool closes = code[at] == '*' && at + 1 < code.Length && code[at + 1] == '/';
                    code[at] = ' ';
                    if (closes) code[++at] = ' ';
                    inComment = !closes;
                }
                else if (code[at] == '/' && at + 1 < code.Length && code[at + 1] == '/')
                {
                    return new string(code, 0, at);
                }
                else if (code[at] == '/' && at + 1 < code.Length && code[at + 1] == '*')
                {
                    inComment = true;
                    code[at] = code[++at] = ' ';
                }
            }
            return new string(code);
        }
    }
}
