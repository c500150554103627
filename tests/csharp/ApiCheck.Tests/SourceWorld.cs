namespace Penumbra.ApiCheck.Tests;

/// <summary>Small sources, declarations and a package, written to disk and checked as the command does.</summary>
public sealed class SourceWorld : IDisposable
{
    public TemporaryFolder Folder { get; } = new();

    public SourceWorld()
    {
        Folder.Write("package/Runtime/Test.Runtime.asmdef", """{ "name": "Test.Runtime" }""");
        const string own = "tests/csharp/UnityApi/Shared/OwnBehaviour.cs";
        Folder.Write("package/" + own, File.ReadAllText(Repository.At(own)));
        Folder.Write("sources/engine/README.md", "## Unity 2022.3.17f1 C# reference source code\n");
        foreach (var (source, package) in new[] { ("core", "core"), ("urp", "universal") })
            Folder.Write($"sources/{source}/package.json", $$"""{ "name": "com.unity.render-pipelines.{{package}}", "version": "14.0.9" }""");
    }

    public void Real(string path, string text) => Folder.Write($"sources/{path}", text);

    public void Declare(string path, string text) => Folder.Write($"package/tests/csharp/UnityApi/{path}", text);

    public void Package(string path, string text) => Folder.Write($"package/{path}", text);

    /// <summary>The sources whose folders are there.</summary>
    public Dictionary<string, string> Sources() => new[] { ("engine", "engine"), ("core", "core"), ("universal", "urp") }
        .Select(one => (Source: one.Item1, Path: Folder.At($"sources/{one.Item2}"))).Where(one => Directory.Exists(one.Path))
        .ToDictionary(one => one.Source, one => one.Path);

    public SourceRequest Request(string generation = "2022.3") =>
        new(generation, Folder.At("package"), Folder.At("package/tests/csharp/UnityApi"), Sources());

    public SourceReport Check(string generation = "2022.3") => SourceReport.Of(generation, SourceCheck.Run(Request(generation)));

    public void Dispose() => Folder.Dispose();
}
