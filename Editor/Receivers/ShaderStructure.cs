using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text.RegularExpressions;

namespace Penumbra.Editor
{
    /// <summary>A pass's properties that determine when it is drawn, and its code.</summary>
    internal sealed class ShaderPassText
    {
        /// <summary>The LightMode tag; empty if there is none.</summary>
        internal string lightMode = "";

        /// <summary>The code of the programs in the pass.</summary>
        internal string code = "";
    }

    internal sealed class SubShaderText
    {
        internal readonly List<ShaderPassText> passes = new List<ShaderPassText>();

        /// <summary>Names of passes taken from other shaders by UsePass, without the shader's name.</summary>
        internal readonly List<string> takenPasses = new List<string>();

        /// <summary>The RenderPipeline tag; empty if there is none.</summary>
        internal string pipeline = "";

        internal int queue = ShaderStructure.Geometry;

        /// <summary>Position of the closing brace.</summary>
        internal int end;
    }

    /// <summary>
    /// The SubShaders of a shader's text with their tags and passes. Comments, strings and programs are separated
    /// from ShaderLab code; other ShaderLab statements are ignored.
    /// </summary>
    internal sealed class ShaderStructure
    {
        internal const int Geometry = 2000;

        // The ShaderLab tokens that matter here, and everything that must be skipped as a whole.
        private static readonly Regex Tokens = new Regex(
            @"//[^\n]*|/\*.*?(\*/|$)|(?<block>\b(HLSL|CG|GLSL)(PROGRAM|INCLUDE)\b)(?<code>.*?)(\bEND(HLSL|CG|GLSL)\b|$)" +
            @"|""(?<text>[^""\n]*)""|(?<word>[A-Za-z_]\w*)|(?<sign>[{}=])", RegexOptions.Singleline);

        internal readonly List<SubShaderText> subShaders = new List<SubShaderText>();

        /// <summary>The code of HLSLINCLUDE blocks, which all programs share.</summary>
        internal string shared = "";

        private readonly List<string> open = new List<string>();  // the keywords before the open braces
        private string word = "";
        private string key;

        internal static ShaderStructure Of(string text)
        {
            var structure = new ShaderStructure();
            foreach (Match token in Tokens.Matches(text)) structure.Take(token);
            return structure;
        }

        private SubShaderText Last => subShaders[subShaders.Count - 1];
        private ShaderPassText LastPass => Last.passes[Last.passes.Count - 1];

        private bool In(string what) => open.FindIndex(one => Is(one, what)) >= 0;
        private static bool Is(string one, string other) => string.Equals(one, other, StringComparison.OrdinalIgnoreCase);

        private void Take(Match token)
        {
            if (token.Groups["block"].Success) TakeCode(token);
            else if (token.Groups["text"].Success) TakeText(token.Groups["text"].Value);
            else if (token.Groups["word"].Success) word = token.Groups["word"].Value;
            else if (token.Groups["sign"].Success) TakeSign(token);
        }

        private void TakeCode(Match token)
        {
            string code = token.Value + "\n";
            if (token.Groups["block"].Value.EndsWith("INCLUDE", StringComparison.Ordinal)) shared += code;
            else if (In("Pass")) LastPass.code += code;
        }

        private void TakeText(string text)
        {
            if (Is(word, "UsePass") && In("SubShader"))
            {
                Last.takenPasses.Add(text.Substring(text.LastIndexOf('/') + 1));
                word = "";
            }
            else if (open.Count > 0 && Is(open[open.Count - 1], "Tags"))
            {
                if (key == null) key = text;
                else TakeTag(text);
            }
        }

        private void TakeTag(string value)
        {
            if (In("Pass"))
            {
                if (Is(key, "LightMode")) LastPass.lightMode = value;
            }
            else if (In("SubShader"))
            {
                if (Is(key, "Queue")) Last.queue = Queue(value);
                if (Is(key, "RenderPipeline")) Last.pipeline = value;
            }
            key = null;
        }

        private void TakeSign(Match token)
        {
            switch (token.Value)
            {
                case "{":
                    if (Is(word, "SubShader")) subShaders.Add(new SubShaderText());
                    if (Is(word, "Pass") && In("SubShader")) Last.passes.Add(new ShaderPassText());
                    open.Add(word);
                    word = "";
                    key = null;
                    break;
                case "}":
                    if (open.Count == 0) break;
                    if (Is(open[open.Count - 1], "SubShader")) Last.end = token.Index;
                    open.RemoveAt(open.Count - 1);
                    break;
            }
        }

        // A queue is, for example, "Geometry+10". A name unknown to Unity counts as its default.
        private static int Queue(string text)
        {
            Match parts = Regex.Match(text, @"^\s*(\w+)\s*([+-]\s*\d+)?\s*$");
            int offset = 0;
            if (parts.Groups[2].Success)
                int.TryParse(parts.Groups[2].Value.Replace(" ", ""), NumberStyles.AllowLeadingSign,
                             CultureInfo.InvariantCulture, out offset);
            switch (parts.Groups[1].Value.ToLowerInvariant())
            {
                case "background": return 1000 + offset;
                case "alphatest": return 2450 + offset;
                case "transparent": return 3000 + offset;
                case "overlay": return 4000 + offset;
                default: return Geometry + offset;
            }
        }
    }
}
