namespace Penumbra.Tests;

/// <summary>
/// The file of techniques says what the programs that measure them say in tests/golden/techniques.json; a feature
/// reads it once, from its asset, and says what is wrong with it.
/// </summary>
public sealed class TechniqueTableTests : FeatureTests
{
    private const string InPackage = "Packages/com.penumbra.shadows/" + TechniqueTable.File;

    [TearDown]
    public void TearDown()
    {
        TechniqueTable.Forget();
        LoadedTechniques.Load();
    }

    private static string Text(JsonElement element, string name) => element.GetProperty(name).GetString();

    private static JsonElement[] Items(JsonElement element, string name) =>
        element.GetProperty(name).EnumerateArray().ToArray();

    private static string Sorted(IEnumerable<string> names) =>
        string.Join(" ", names.OrderBy(name => name, StringComparer.Ordinal));

    private static string PassOf(TechniqueGraph graph, GraphPass pass) =>
        $"{pass.kind} {pass.runs} {pass.asset} {pass.program} ".ToLowerInvariant() +
        Sorted(pass.reads.Select(read => read.property + "=" + graph.textures[read.index].name)) + " > " +
        Sorted(pass.writes.Concat(pass.updates).Select(write => graph.textures[write.index].name));

    private static string PassOf(JsonElement pass) =>
        $"{Text(pass, "kind")} {Text(pass, "runs")} {Text(pass, "file")} {Text(pass, "program")} ".ToLowerInvariant() +
        Sorted(pass.GetProperty("reads").EnumerateObject().Select(read => read.Name + "=" + read.Value)) + " > " +
        Sorted(WritesOf(pass.GetProperty("writes")));

    // A kernel has a name for each, a pass that draws an array of targets.
    private static IEnumerable<string> WritesOf(JsonElement writes) =>
        writes.ValueKind == JsonValueKind.Array ? writes.EnumerateArray().Select(name => name.GetString())
                                                : writes.EnumerateObject().Select(write => write.Value.GetString());

    private static string TextureOf(GraphTexture one) =>
        $"{one.name} {one.extent} {one.divisor} {one.width} {one.height} {one.depth} {one.mips} {one.layers} " +
        one.samples;

    private static string TextureOf(JsonElement one)
    {
        int[] size = Items(one, "size").Select(number => number.GetInt32()).ToArray();
        string extent = Text(one, "extent");
        return $"{Text(one, "name")} {char.ToUpperInvariant(extent[0])}{extent.Substring(1)} " +
               $"{one.GetProperty("divisor")} {size[0]} {size[1]} {Math.Max(size[2], 1)} " +
               $"{one.GetProperty("mips")} {one.GetProperty("layers")} {one.GetProperty("samples")}";
    }

    private static IEnumerable<string> Described(TechniqueGraph graph) =>
        graph.textures.Select(TextureOf).Concat(graph.passes.Select(pass => PassOf(graph, pass)));

    private static IEnumerable<string> Described(JsonElement technique) =>
        Items(technique, "textures").Select(TextureOf)
            .Concat(Items(technique, "passes").Where(pass => Text(pass, "kind") != "filter").Select(PassOf));

    /// <summary>The program that measures a technique runs the same passes over the same textures.</summary>
    [Test]
    public void EveryGraphOfATechniqueIsOneThatIsMeasured()
    {
        var measured = new HashSet<string>(Items(Measured.List, "techniques").Select(technique => string.Join("\n", Described(technique))));
        TechniqueGraph[] graphs = TechniqueTable.Entries.SelectMany(entry => entry.formats)
            .Select(format => format.graph).Where(graph => graph != null).ToArray();
        Assert.That(graphs.Length, Is.GreaterThan(15));
        foreach (TechniqueGraph graph in graphs)
            Assert.That(measured, Has.Member(string.Join("\n", Described(graph))), graph.name);
    }

    [TestCase(float.NaN, 0.0f)]
    [TestCase(7.0f, 0.95f)]
    [TestCase(-1.0f, 0.0f)]
    [TestCase(0.5f, 0.5f)]
    public void AnOptionIsClampedToTheRangeOfItsParameter(float value, float expected)
    {
        var options = new ShadowOptions { lightBleeding = value };
        var component = new ParameterComponent(NumberOption.lightBleeding, 0.0f, 0.95f);
        Assert.That(component.In(options), Is.EqualTo(expected));
    }

    [Test]
    public void EveryNumberOptionIsItsField()
    {
        foreach (NumberOption option in Enum.GetValues(typeof(NumberOption)))
        {
            ShadowOptions options = default;
            OptionTable.Set(ref options, option, 3.0f);
            FieldInfo field = typeof(ShadowOptions).GetField(option.ToString());
            Assert.That(Convert.ToSingle(field.GetValue(options)), Is.EqualTo(3.0f), option.ToString());
            Assert.That(OptionTable.Get(options, option), Is.EqualTo(3.0f), option.ToString());
        }
    }

    [Test]
    public void APlayersFeatureReadsItsAsset()
    {
        TechniqueTable.Forget();
        AssetDatabase.Assets.Clear();  // a player has none
        feature.Create();
        Assert.That(TechniqueTable.Problem, Is.Null);
        Render();
        Assert.That(feature.LastSkip, Is.EqualTo(SkipReason.None));
    }

    [Test]
    public void WithoutTheFileTheFrameIsUrpsUntilItIsImported()
    {
        feature.Dispose();
        TechniqueTable.Forget();
        AssetDatabase.Assets.Remove(InPackage);
        feature = new PenumbraShadows();
        feature.Create();
        Render();
        Assert.That(keywords.AtOpaques, Is.EqualTo(ShadowKeywords.CascadesName));
        Assert.That(feature.LastSkip, Is.EqualTo(SkipReason.MissingPass));
        Assert.That(feature.MissingPass, Is.EqualTo("Runtime/Techniques/Techniques.txt is missing"));
        Assert.That(Assert.Throws<InvalidOperationException>(() => ShadowTechnique.Pcss.Entry()).Message,
                    Is.EqualTo(feature.MissingPass));
        AssetDatabase.Assets[InPackage] = LoadedTechniques.File();
        Render();
        Assert.That(feature.LastSkip, Is.EqualTo(SkipReason.None));
    }

    /// <summary>An inspector or a build may come before any feature.</summary>
    [Test]
    public void TheEditorReadsThePackagesFile()
    {
        TechniqueTable.Forget();
        Assert.That(ShadowTechnique.Pcss.Entry().keyword, Is.EqualTo("_PENUMBRA_PCSS"));
    }

    [Test]
    public void AnEditIsReadWhenItIsImported()
    {
        int imports = ChainDraw.Imports;
        AssetDatabase.Assets[InPackage] =
            new TextAsset(LoadedTechniques.Text().Replace("keyword=_PENUMBRA_PCSS\t", "keyword=_OTHER\t"));
        var none = new string[0];
        Editor.ShaderImports.OnPostprocessAllAssets(new[] { InPackage }, none, none, none);
        Assert.That(ShadowTechnique.Pcss.Entry().keyword, Is.EqualTo("_OTHER"));
        Assert.That(ChainDraw.Imports, Is.EqualTo(imports + 1));
    }

    [Test]
    public void LinesMayEndAsOnWindows()
    {
        TechniqueTable.Forget();
        var file = new TextAsset(LoadedTechniques.Text().Replace("\n", "\r\n"));
        Assert.That(TechniqueTable.Load(file), TechniqueTable.Problem);
        Assert.That(TechniqueTable.Graph("variance-32").filtersLinearly);
    }

    private static string Refusal(string from, string to)
    {
        string text = LoadedTechniques.Text();
        Assert.That(text, Does.Contain(from));
        int at = text.IndexOf(from, StringComparison.Ordinal);
        TechniqueTable.Forget();
        var file = new TextAsset(text.Substring(0, at) + to + text.Substring(at + from.Length));
        Assert.That(TechniqueTable.Load(file), Is.False);
        string problem = TechniqueTable.Problem;
        Assert.That(TechniqueTable.Load(file), Is.False);
        Assert.That(TechniqueTable.Problem, Is.SameAs(problem), "it is read once, not in every frame");
        return problem;
    }

    [TestCase("rows\tMap\tR32G32_SFloat", "rows\tMap\tR33_SFloat", "LINE: unknown GraphicsFormat 'R33_SFloat'")]
    [TestCase("texture\trows\tMap", "texture\trows\tMaps", "LINE: unknown GraphExtent 'Maps'")]
    [TestCase("write\t\trows", "write\t\trow", "LINE: graph 'variance-32' has no texture 'row'")]
    [TestCase("write\t\trows", "write\t", "LINE: the row has too few columns")]
    [TestCase("write\t\trows", "write\t\trows\tmoments", "LINE: unknown column 'moments'")]
    [TestCase("write\t\trows", "writes\t\trows", "LINE: no row 'writes' belongs here")]
    [TestCase("graph\tvariance-32\n", "", "LINE: no row 'texture' belongs here")]
    [TestCase("graph\tvariance-16", "graph\tvariance-32", "LINE: there are two graphs 'variance-32'")]
    [TestCase("samples=4", "samples=four", "LINE: 'four' is not a whole number")]
    [TestCase("samples=4", "sample=4", "LINE: unknown column 'sample=4'")]
    [TestCase("graph\tpcss\n", "graph\tpcs\n", "has no graph 'pcss'")]
    [TestCase("technique\tPcss\t", "technique\tPcs\t", "LINE: unknown ShadowTechnique 'Pcs'")]
    [TestCase("technique\tTent7x7\t", "technique\tTent5x5\t", "there is no technique Tent7x7")]
    [TestCase("technique\tTent5x5\tTent5x5\nformat\n", "technique\tTent5x5\tTent5x5\n",
              "no row 'format' follows technique Tent5x5")]
    [TestCase("option\tblockerSamples", "option\tblockersamples", "LINE: unknown NumberOption 'blockersamples'")]
    [TestCase("format\tgraph=variance-32", "format\tgraph=variance", "LINE: there is no graph 'variance'")]
    [TestCase("lightBleeding:0:0.95", "lightBleeding:0:a", "LINE: 'a' is not a number")]
    [TestCase("lightBleeding:0:0.95", "lightBleeding", "LINE: 'lightBleeding' is not a number")]
    public void WhatIsWrongIsNamedWithItsLine(string from, string to, string message)
    {
        string before = LoadedTechniques.Text();
        before = before.Substring(0, before.IndexOf(from, StringComparison.Ordinal));
        string problem = Refusal(from, to);
        Assert.That(problem, Does.StartWith("Runtime/Techniques/Techniques.txt"));
        Assert.That(problem, Does.Contain(message.Replace("LINE", ":" + (before.Count(one => one == '\n') + 1))));
    }
}
