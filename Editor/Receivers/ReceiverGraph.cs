using System.Collections.Generic;
using System.Text.RegularExpressions;

namespace Penumbra.Editor
{
    /// <summary>
    /// Reads of a Shader Graph's file how it takes the main light's shadow. URP's lit target writes pragmas with the
    /// screen keyword by itself; a graph of another target (a custom lighting on the unlit one) declares the map's
    /// keywords on its blackboard, and needs the screen's beside them.
    /// </summary>
    internal static class ReceiverGraph
    {
        private const string Lit = "UnityEditor.Rendering.Universal.ShaderGraph.UniversalLitSubTarget";
        private const string Keyword = "UnityEditor.ShaderGraph.ShaderKeyword";

        // KeywordType.Enum, KeywordDefinition.Predefined in Shader Graph 14 and 17.
        private const string Enumeration = "1";
        private const string Predefined = "2";

        // The file is a row of objects, each with its type before its fields.
        private static readonly Regex ObjectType = new Regex("\"m_Type\"\\s*:\\s*\"([^\"]*)\"");

        internal static ReceiverKind KindOf(string json)
        {
            var keywords = new HashSet<string>();
            bool isLit = false;
            for (Match type = ObjectType.Match(json); type.Success;)
            {
                Match next = type.NextMatch();
                string fields = json.Substring(type.Index, (next.Success ? next.Index : json.Length) - type.Index);
                isLit |= type.Groups[1].Value == Lit;
                if (type.Groups[1].Value == Keyword && Field(fields, "m_KeywordDefinition") != Predefined)
                    keywords.UnionWith(Declared(fields));
                type = next;
            }
            if (!keywords.Contains(ShadowKeywords.MapName) && !keywords.Contains(ShadowKeywords.CascadesName))
                return ReceiverKind.None;
            return isLit || keywords.Contains(ShadowKeywords.ScreenName) ? ReceiverKind.Complete
                                                                         : ReceiverKind.LacksScreen;
        }

        // An enumeration's keywords are its reference and an entry's, with _ between.
        private static IEnumerable<string> Declared(string fields)
        {
            string written = Field(fields, "m_OverrideReferenceName");
            string reference = written.Length > 0 ? written : Field(fields, "m_DefaultReferenceName");
            if (Field(fields, "m_KeywordType") != Enumeration)
            {
                yield return reference;
                yield break;
            }
            foreach (Match entry in Regex.Matches(fields, Pattern("referenceName")))
                yield return reference + "_" + entry.Groups[1].Value;
        }

        private static string Field(string fields, string name) => Regex.Match(fields, Pattern(name)).Groups[1].Value;

        private static string Pattern(string name) => "\"" + name + "\"\\s*:\\s*\"?([^\",}\\s]*)";
    }
}
