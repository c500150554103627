using System;
using System.Collections.Generic;
using System.Globalization;
using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    /// <summary>
    /// Reads Techniques.txt: a row per line, its columns separated by tabs. A row `graph` or `technique` begins what
    /// the rows after it say more about. Columns that a row may have or not are `name=value`, or a name alone.
    /// </summary>
    internal sealed class TechniqueReader
    {
        internal readonly Dictionary<string, TechniqueGraph> graphs = new Dictionary<string, TechniqueGraph>();
        private readonly List<KeyValuePair<ShadowTechnique, TechniqueEntry>> techniques =
            new List<KeyValuePair<ShadowTechnique, TechniqueEntry>>();

        private TechniqueGraph graph;
        private GraphPass pass;
        private TechniqueEntry technique;
        private TechniqueFormat format;

        private string[] columns;
        private bool[] used;
        private int line;
        private int next;

        internal TechniqueReader(string text)
        {
            foreach (string row in text.Split('\n'))
            {
                ++line;
                columns = row.TrimEnd('\r').Split('\t');
                if (columns[0].Length == 0 || columns[0][0] == '#') continue;
                used = new bool[columns.Length];
                next = 0;
                ReadRow(Text());
                int unknown = Array.IndexOf(used, false);
                if (unknown >= 0) throw Wrong("unknown column '" + columns[unknown] + "'");
            }
        }

        /// <summary>The entries by ShadowTechnique. Throws FormatException unless each value has one.</summary>
        internal TechniqueEntry[] OfEveryTechnique()
        {
            var entries = new TechniqueEntry[Enum.GetValues(typeof(ShadowTechnique)).Length];
            foreach (KeyValuePair<ShadowTechnique, TechniqueEntry> one in techniques) entries[(int)one.Key] = one.Value;
            int missing = Array.IndexOf(entries, null);
            if (missing >= 0) throw Wrong("there is no technique " + (ShadowTechnique)missing);
            missing = Array.FindIndex(entries, entry => entry.formats.Length == 0);
            return missing < 0 ? entries : throw Wrong("no row 'format' follows technique " + (ShadowTechnique)missing);
        }

        private void ReadRow(string kind)
        {
            switch (kind)
            {
                case "graph":
                    graph = new TechniqueGraph { name = Text() };
                    if (graphs.ContainsKey(graph.name)) throw Wrong("there are two graphs '" + graph.name + "'");
                    graphs.Add(graph.name, graph);
                    pass = null;
                    break;
                case "technique":
                    technique = ReadTechnique(Value<ShadowTechnique>());
                    format = null;
                    break;
                default:
                    bool belongs = technique != null ? ReadOfTechnique(kind)
                                       : pass != null && ReadOfPass(kind) || graph != null && ReadOfGraph(kind);
                    if (!belongs) throw Wrong("no row '" + kind + "' belongs here");
                    break;
            }
        }

        private bool ReadOfGraph(string kind)
        {
            switch (kind)
            {
                case "texture": Append(ref graph.textures, ReadTexture()); break;
                case "previous": graph.textures[Texture()].previousOf = Texture(); break;
                case "pass":
                    pass = new GraphPass
                    {
                        kind = Value<PassKind>(), runs = Value<PassFrequency>(), asset = Text(), program = Text(),
                        testsShadowMap = Has("testsShadowMap"), blended = Has("blended"), eachMip = Has("eachMip"),
                    };
                    Append(ref graph.passes, pass);
                    break;
                case "keyword": Append(ref graph.keywords, Text()); break;
                case "filterTexture":
                    Append(ref graph.filterTextures, Binding());
                    graph.filtersLinearly |= Has("linear");
                    break;
                case "visibility": graph.visibility = Texture(); break;
                case "source": graph.source = Texture(); break;
                case "mask": graph.mask = Texture(); break;
                default: return false;
            }
            return true;
        }

        private bool ReadOfPass(string kind)
        {
            switch (kind)
            {
                case "read": Append(ref pass.reads, Binding()); break;
                case "write": Append(ref pass.writes, Binding()); break;
                case "update": Append(ref pass.updates, Binding()); break;
                case "absent": Append(ref pass.absent, Text()); break;
                case "depth": pass.depth = Texture(); break;
                case "groups": pass.groups = GraphGroups.Fixed(Count(), Count(), Count()); break;
                case "groupsOfTexels": pass.groups = GraphGroups.TexelsOf(Texture(), Count("divisor", 1)); break;
                default: return false;
            }
            return true;
        }

        private bool ReadOfTechnique(string kind)
        {
            switch (kind)
            {
                case "option":
                    string option = Text();
                    var number = Value<NumberOption>(option);
                    Append(ref technique.options,
                           new MeasuredOption { name = option, number = number, value = Number() });
                    break;
                case "cascade":
                    string uniform = Text(), copied = Text();
                    Append(ref technique.cascades,
                           new CascadeVector(uniform, copied.Length == 0 ? null : copied, Count(), Number(), Number(),
                                             Number(), Number()));
                    break;
                case "half": technique.halfGraph = Graph(Text()); break;
                case "format":
                    string name = Named("graph");
                    format = new TechniqueFormat { graph = name == null ? null : Graph(name) };
                    Append(ref technique.formats, format);
                    break;
                case "vector" when format != null:
                    Append(ref format.parameters,
                           new ParameterVector(Text(), Component(), Component(), Component(), Component()));
                    break;
                default: return false;
            }
            return true;
        }

        private TechniqueEntry ReadTechnique(ShadowTechnique value)
        {
            var entry = new TechniqueEntry
            {
                fallback = Value<ShadowTechnique>(), keyword = Named("keyword"), takesSamples = Has("takesSamples"),
                widensWithDisc = Has("widensWithDisc"), needsTarget45 = Has("needsTarget45"),
                limitsWidth = Has("limitsWidth"), hasOwnBias = Has("hasOwnBias"),
            };
            techniques.Add(new KeyValuePair<ShadowTechnique, TechniqueEntry>(value, entry));
            return entry;
        }

        private GraphTexture ReadTexture() =>
            new GraphTexture(Text(), Value<GraphExtent>(), Value<GraphicsFormat>(), Count("divisor", 1),
                             Count("width", 0), Count("height", 0), Count("depth", 1), Count("mips", 1),
                             Count("layers", 1), Count("samples", 1));

        // A render target's name in the program is empty.
        private GraphBinding Binding()
        {
            string property = Text();
            return property.Length == 0 ? GraphBinding.Texture(Texture()) : GraphBinding.Texture(property, Texture());
        }

        // A number, or option:low:high.
        private ParameterComponent Component()
        {
            string[] parts = Text().Split(':');
            return parts.Length == 3
                       ? new ParameterComponent(Value<NumberOption>(parts[0]), Number(parts[1]), Number(parts[2]))
                       : new ParameterComponent(Number(parts[0]));
        }

        private TechniqueGraph Graph(string name) =>
            graphs.TryGetValue(name, out TechniqueGraph found)
                ? found : throw Wrong("there is no graph '" + name + "'");

        private int Texture()
        {
            string name = Text();
            int index = Array.FindIndex(graph.textures, texture => texture.name == name);
            return index >= 0 ? index : throw Wrong("graph '" + graph.name + "' has no texture '" + name + "'");
        }

        /// <summary>The next column.</summary>
        private string Text()
        {
            if (next == columns.Length) throw Wrong("the row has too few columns");
            used[next] = true;
            return columns[next++];
        }

        /// <summary>The column NAME=... after those that every such row has; null without one.</summary>
        private string Named(string name)
        {
            int at = Array.FindIndex(columns, next, column => column.StartsWith(name + "=", StringComparison.Ordinal));
            if (at < 0) return null;
            used[at] = true;
            return columns[at].Substring(name.Length + 1);
        }

        private bool Has(string name)
        {
            int at = Array.IndexOf(columns, name, next);
            if (at >= 0) used[at] = true;
            return at >= 0;
        }

        private T Value<T>() where T : struct => Value<T>(Text());

        private T Value<T>(string text) where T : struct =>
            Enum.TryParse(text, out T value) && Enum.IsDefined(typeof(T), value)
                ? value : throw Wrong("unknown " + typeof(T).Name + " '" + text + "'");

        private int Count() => Count(Text());

        private int Count(string name, int otherwise)
        {
            string text = Named(name);
            return text == null ? otherwise : Count(text);
        }

        private int Count(string text) =>
            int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int count)
                ? count : throw Wrong("'" + text + "' is not a whole number");

        private float Number() => Number(Text());

        private float Number(string text) =>
            float.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out float number)
                ? number : throw Wrong("'" + text + "' is not a number");

        private FormatException Wrong(string what) =>
            new FormatException(TechniqueTable.File + ":" + line + ": " + what);

        private static void Append<T>(ref T[] items, T item)
        {
            Array.Resize(ref items, items.Length + 1);
            items[items.Length - 1] = item;
        }
    }
}
