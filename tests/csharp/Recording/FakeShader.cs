using System.Runtime.CompilerServices;
using System.Text.RegularExpressions;

namespace Penumbra.Tests;

/// <summary>
/// The package's shaders, as far as their passes' names and keywords go. They are read from the files themselves.
/// </summary>
internal static class FakeShader
{
    private const string FrameFile = "PenumbraShadows.shader";
    private const string MapFile = "PenumbraMaps.shader";
    private const string TraceFile = "PenumbraScreenTrace.shader";
    private const string AccumulateFile = "PenumbraAccumulate.shader";
    private const string FarFile = "PenumbraFar.shader";
    private const string SumsFile = "SummedAreas.compute";
    private const string TiledPcssFile = "PenumbraTiledPcss.compute";

    /// <summary>The shader of passes over the shadow map; imported, as far as the editor goes.</summary>
    internal static Shader Maps { get; private set; }

    /// <summary>The shader of shadows beyond the cascades; imported, too.</summary>
    internal static Shader Far { get; private set; }

    /// <summary>The kernels of summed-area tables; imported, too.</summary>
    internal static ComputeShader Sums { get; private set; }

    /// <summary>The kernels of Tiled PCSS; imported, too.</summary>
    internal static ComputeShader TiledPcss { get; private set; }

    /// <summary>The frame's own shader.</summary>
    internal static Shader Screen { get; private set; }

    /// <summary>Installs all shaders of passes, and returns the frame's own.</summary>
    internal static Shader Install()
    {
        const string folder = "Packages/com.penumbra.shadows/Shaders/";
        AssetDatabase.Assets["Packages/com.penumbra.shadows/" + TechniqueTable.File] = LoadedTechniques.File();
        Install(DebugViewDraw.ShaderName, "PenumbraDebugViews.shader");
        AssetDatabase.Assets[folder + MapFile] = Maps = Install("Hidden/Penumbra/Maps", MapFile);
        AssetDatabase.Assets[folder + TraceFile] = Install("Hidden/Penumbra/ScreenTrace", TraceFile);
        AssetDatabase.Assets[folder + AccumulateFile] = Install("Hidden/Penumbra/Accumulate", AccumulateFile);
        AssetDatabase.Assets[folder + FarFile] = Far = Install("Hidden/Penumbra/Far", FarFile);
        AssetDatabase.Assets[folder + SumsFile] = Sums = Kernels(SumsFile);
        AssetDatabase.Assets[folder + TiledPcssFile] = TiledPcss = Kernels(TiledPcssFile);
        return Screen = Install(PenumbraShadows.ShaderName, FrameFile);
    }

    private static ComputeShader Kernels(string file)
    {
        var shader = new ComputeShader
        {
            name = Path.GetFileNameWithoutExtension(file), KeywordNames = KernelKeywords(file).ToList(),
        };
        foreach ((string name, uint[] threads) in KernelSizes(file))
            shader.Kernels.Add(new ComputeShader.Kernel { Name = name, X = threads[0], Y = threads[1], Z = threads[2] });
        return shader;
    }

    // Each file is read once, since every test installs the shaders anew.
    private static Func<string, T> Once<T>(Func<string, T> read)
    {
        var known = new Dictionary<string, T>();
        return file => known.TryGetValue(file, out T answer) ? answer : known[file] = read(file);
    }

    private static readonly Func<string, string> Text =
        Once(file => File.ReadAllText(Path.Combine(PackageRoot(), "Shaders", file)));

    private static readonly Func<string, string[]> Passes =
        Once(file => Regex.Matches(Text(file), "Name \"(\\w+)\"").Select(name => name.Groups[1].Value).ToArray());

    private static readonly Func<string, string[]> KernelKeywords =
        Once(file => Regex.Matches(Text(file), "#pragma multi_compile_local (.*)")
                 .SelectMany(pragma => pragma.Groups[1].Value.Split(' ')).Where(name => name != "_").ToArray());

    private static readonly Func<string, (string name, uint[] threads)[]> KernelSizes =
        Once(file => Regex.Matches(Text(file), "#pragma kernel (\\w+)")
                 .Select(kernel => (kernel.Groups[1].Value, Threads(file, kernel.Groups[1].Value))).ToArray());

    private static uint[] Threads(string file, string kernel) =>
        Regex.Match(Text(file), "\\[numthreads\\((.*)\\)\\]\\s+void " + kernel + "\\(").Groups[1].Value
            .Split(", ").Select(count => Number(file, count)).ToArray();

    // The count may be a macro of the file, or of one that it includes.
    private static uint Number(string file, string count)
    {
        if (uint.TryParse(count, out uint number)) return number;
        Match macro = Regex.Match(Text(file), "#define " + count + " (\\d+)");
        if (macro.Success) return uint.Parse(macro.Groups[1].Value);
        return Regex.Matches(Text(file), "#include \"([^\"]+.hlsl)\"")
            .Select(include => include.Groups[1].Value)
            .Where(path => !path.StartsWith("Packages/"))
            .Select(path => Number(Path.Combine(Path.GetDirectoryName(file), path), count))
            .FirstOrDefault(found => found > 0);
    }

    private static Shader Install(string name, string file)
    {
        var shader = new Shader { name = name };
        foreach (string pass in Passes(file)) shader.PassNames.Add(pass);
        Shader.Known[name] = shader;
        return shader;
    }

    internal static string PackageRoot([CallerFilePath] string here = "") =>
        Path.GetFullPath(Path.Combine(Path.GetDirectoryName(here), "..", "..", ".."));

    /// <summary>The variants of the frame's shader.</summary>
    internal static Dictionary<string, List<HashSet<string>>> FragmentVariants() => VariantsOf(FrameFile);

    /// <summary>The keywords of the frame's shader that ask for shader target 4.5.</summary>
    internal static string[] KeywordsOfTarget45() =>
        Regex.Match(Text(FrameFile), "#pragma target 4.5 (_.*)").Groups[1].Value.Split(' ');

    /// <summary>The variants of the shader of passes over the shadow map.</summary>
    internal static Dictionary<string, List<HashSet<string>>> MapVariants() => VariantsOf(MapFile);

    /// <summary>The variants of the shader of shadows beyond the cascades.</summary>
    internal static Dictionary<string, List<HashSet<string>>> FarVariants() => VariantsOf(FarFile);

    // The keyword sets of the fragment programs, by pass: one keyword of every multi_compile line.
    private static readonly Func<string, Dictionary<string, List<HashSet<string>>>> VariantsOf = Once(file =>
    {
        var variants = new Dictionary<string, List<HashSet<string>>>();
        foreach (Match pass in Regex.Matches(Text(file), "Name \"(\\w+)\"(.*?)ENDHLSL", RegexOptions.Singleline))
        {
            var sets = new List<HashSet<string>> { new HashSet<string>() };
            foreach (Match line in Regex.Matches(pass.Groups[2].Value, "#pragma multi_compile_local_fragment (.*)"))
                sets = sets.SelectMany(set => line.Groups[1].Value.Split(' ').Select(name => With(set, name))).ToList();
            variants.Add(pass.Groups[1].Value, sets);
        }
        return variants;
    });

    private static HashSet<string> With(HashSet<string> set, string name) =>
        new HashSet<string>(name == "_" ? set : set.Append(name));
}
