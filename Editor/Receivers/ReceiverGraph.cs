using System.Collections.Generic;
using System.Text.RegularExpressions;

namespace Penumbra.Editor
{
    /// <summary>
    /// Finds out from a Shader Graph's file how the graph receives the main light's shadow. URP's lit target
    /// generates pragmas with the screen keyword; a graph with another target (custom lighting on the unlit target)
    /// declares the map's keywords on its blackboard, and also needs the screen keyword.
    /// </summary>
    internal static class ReceiverGraph
    {
        private const string Lit = "UnityEditor.Rendering.Universal.ShaderGraph.UniversalLitSubTarget";
        private const string Keyword = "UnityEditor.ShaderGraph.ShaderKeyword";

        // These are the values of KeywordType.Enum and KeywordDefinition.Predefined in Shader Graph 14 and 17.
        private const string Enumeration = "1";
        private const string Predefined = "2";

        // The file is a sequence of objects, each with its type before its fields.
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

        // The keywords of an enumeration are its reference name, _ and an entry's name.
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
