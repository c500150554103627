using System;
using System.Collections.Generic;

namespace Penumbra.Editor
{
    /// <summary>How a shader takes the main light's shadow.</summary>
    public enum ReceiverKind
    {
        /// <summary>Names no main light shadow keyword: it takes no shadow, or by an include that names them.</summary>
        None,

        /// <summary>Reads the screen-space texture where it is asked to.</summary>
        Complete,

        /// <summary>A pragma lacks the screen keyword: its surfaces lose their shadow while the feature is on.</summary>
        LacksScreen,
    }

    /// <summary>
    /// Finds the pragmas of a shader's text that name URP's main light shadow keywords, and adds the one that is
    /// missing. A pragma is read as a line; what stands in comments is left alone.
    /// </summary>
    internal static class ReceiverPragma
    {
        internal static ReceiverKind KindOf(string text)
        {
            ReceiverKind kind = ReceiverKind.None;
            foreach (Line line in Lines(text))
            {
                if (!NamesMap(line.words)) continue;
                if (Array.IndexOf(line.words, ShadowKeywords.ScreenName) < 0) return ReceiverKind.LacksScreen;
                kind = ReceiverKind.Complete;
            }
            return kind;
        }

        /// <summary>The text with the keyword at the end of every pragma that lacks it; line ends stay as they are.</summary>
        internal static string WithScreen(string text)
        {
            int added = 0;
            string name = " " + ShadowKeywords.ScreenName;
            foreach (Line line in Lines(text))
            {
                if (!NamesMap(line.words) || Array.IndexOf(line.words, ShadowKeywords.ScreenName) >= 0) continue;
                text = text.Insert(line.end + added, name);
                added += name.Length;
            }
            return text;
        }

        private static bool NamesMap(string[] words)
        {
            if (words.Length < 2 || words[0] != "#pragma" || !IsVariantPragma(words[1])) return false;
            return Array.IndexOf(words, ShadowKeywords.MapName) >= 0 ||
                   Array.IndexOf(words, ShadowKeywords.CascadesName) >= 0;
        }

        private static bool IsVariantPragma(string word) =>
            word.StartsWith("multi_compile", StringComparison.Ordinal) ||
            word.StartsWith("shader_feature", StringComparison.Ordinal);

        private struct Line
        {
            internal string[] words;
            internal int end;  // behind its last word
        }

        private static IEnumerable<Line> Lines(string text)
        {
            bool inComment = false;
            for (int start = 0; start < text.Length;)
            {
                int newline = text.IndexOf('\n', start);
                int end = newline < 0 ? text.Length : newline;
                string code = WithoutComments(text.Substring(start, end - start), ref inComment);
                string trimmed = code.TrimEnd();
                yield return new Line
                {
                    words = trimmed.Split(new[] { ' ', '\t' }, StringSplitOptions.RemoveEmptyEntries),
                    end = start + trimmed.Length,
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
