using System;
using System.Collections.Generic;
using System.Linq;

namespace Penumbra.Editor
{
    /// <summary>The way in which a shader receives the main light's shadow.</summary>
    public enum ReceiverKind
    {
        /// <summary>
        /// The shader declares none of these keywords: it has no shadow, or an include file declares them.
        /// </summary>
        None,

        /// <summary>The shader declares the screen keyword, so that it can read the screen-space texture.</summary>
        Complete,

        /// <summary>A program lacks the screen keyword: its surfaces have no shadow while the feature is on.</summary>
        LacksScreen,
    }

    /// <summary>
    /// Finds the programs of a shader's text whose pragmas declare URP's main light shadow keywords, and adds the
    /// missing keyword. A program is the text from HLSLPROGRAM to ENDHLSL (or the CG equivalents) plus the HLSLINCLUDE
    /// blocks of the file; an include file counts as one program. Each line is one pragma; comments are ignored.
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
        /// The text with the keyword added once to every program that lacks it, at the end of the pragma for cascades
        /// or else of the one for the map; line endings are preserved.
        /// </summary>
        internal static string WithScreen(string text)
        {
            var lacking = new SortedSet<int>();
            foreach (Line[] program in Receivers(text))
            {
                if (HasScreen(program)) continue;
                Line pragma = Array.Find(program, one => one.Names(ShadowKeywords.CascadesName)) ??
                                Array.Find(program, one => one.Names(ShadowKeywords.MapName));
                pragma.addsScreen = true;  // a shared block adds the keyword to later programs too
                lacking.Add(pragma.end);
            }
            foreach (int end in lacking.Reverse()) text = text.Insert(end, " " + ShadowKeywords.ScreenName);
            return text;
        }

        // The variant pragmas of each program that declares a keyword of the shadow map.
        private static List<Line[]> Receivers(string text)
        {
            var outside = new List<Line>();  // for an include file this is the whole file
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
            internal int end;  // position after its last word
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

        // The line keeps its length up to the end of the code, as comments become blanks.
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
