using System.Text.RegularExpressions;

namespace Penumbra.Tests;

/// <summary>
/// The techniques of tests/techniques/added, which the C++ tools run too, in the place of one of the feature's: their
/// graphs as `penumbra emit` writes them, their assets as far as names and groups of threads go.
/// </summary>
internal static class AddedTechniques
{
    internal const ShadowTechnique Place = ShadowTechnique.Tent3x3;

    private const string Package = "Packages/com.penumbra.shadows/";

    private static string Text(string file) =>
        File.ReadAllText(Path.Combine(FakeShader.PackageRoot(), "tests", "techniques", "added", file));

    internal static TechniqueGraph Layers => Graph("Layers", "layers");

    private static TechniqueGraph Graph(string file, string name) =>
        new TechniqueReader(Text("Runtime/Techniques/" + file + ".txt")).graphs[name];

    /// <summary>Adds the shader of Means and imports it, as far as the editor goes.</summary>
    internal static Shader AddMeans() => Add(Graph("Means", "means"), "Means");

    /// <summary>Adds the shader of Layers, whose passes draw the casters, in the same way.</summary>
    internal static Shader AddLayers() => Add(Layers, "Layers");

    private static Shader Add(TechniqueGraph graph, string name)
    {
        Use(graph);
        var shader = new Shader { name = "Hidden/" + name, KeywordNames = new List<string>() };
        foreach (Match pass in Regex.Matches(Text(name + ".shader"), "Name \"(\\w+)\""))
            shader.PassNames.Add(pass.Groups[1].Value);
        AssetDatabase.Assets[Package + name + ".shader"] = shader;
        return shader;
    }

    /// <summary>Adds the kernels of Blocks in the same way.</summary>
    internal static ComputeShader AddBlocks() => AddKernels(Graph("Blocks", "blocks"));

    /// <summary>Adds the same kernels; one of them fills the visibility that another updates.</summary>
    internal static ComputeShader AddFilledBlocks() => AddKernels(Graph("FilledBlocks", "blocks-filled"));

    private static ComputeShader AddKernels(TechniqueGraph graph)
    {
        Use(graph);
        var kernels = new ComputeShader { name = "Blocks" };
        foreach (Match kernel in Regex.Matches(Text("Blocks.compute"),
                                               "\\[numthreads\\((\\d+), (\\d+), (\\d+)\\)\\]\\s+void (\\w+)"))
            kernels.Kernels.Add(new ComputeShader.Kernel
            {
                Name = kernel.Groups[4].Value, X = uint.Parse(kernel.Groups[1].Value),
                Y = uint.Parse(kernel.Groups[2].Value), Z = uint.Parse(kernel.Groups[3].Value),
            });
        AssetDatabase.Assets[Package + "Blocks.compute"] = kernels;
        return kernels;
    }

    /// <summary>Gives this graph to the technique whose place is taken.</summary>
    internal static void Use(TechniqueGraph graph) => Place.Entry().formats[0].graph = graph;

    internal static void Remove()
    {
        Use(null);
        AssetDatabase.Assets.Clear();
    }

    internal static ShadowOptions Options()
    {
        ShadowOptions options = PresetFallback.Options(QualityPreset.Medium);
        options.technique = Place;
        return options;
    }
}
