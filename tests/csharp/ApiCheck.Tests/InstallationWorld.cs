using Microsoft.CodeAnalysis.CSharp;

namespace Penumbra.ApiCheck.Tests;

/// <summary>
/// A Unity installation, a project and a small package on disk. The engine's module holds all of our declarations; the
/// other assemblies have their names and a type each.
/// </summary>
public sealed class InstallationWorld : IDisposable
{
    public const string Data = "2022.3.17f1/Editor/Data";
    private static readonly Dictionary<string, byte[]> Engines = [];

    public TemporaryFolder Folder { get; } = new();

    public string Package => Folder.At("package");
    public string Project => Folder.At("Project");
    public string Installation => Folder.At("2022.3.17f1");

    public void Dispose() => Folder.Dispose();

    public InstallationWorld WithPackage()
    {
        Folder.Write("package/Runtime/Probe.Runtime.asmdef", """
            { "name": "Probe.Runtime", "references": [ "Unity.RenderPipelines.Core.Runtime", "Unity.RenderPipelines.Universal.Runtime" ] }
            """);
        Folder.Write("package/Runtime/Probe.cs",
                     "public static class Probe { public static int Size(int a) => UnityEngine.Mathf.Clamp(a, 1, 64); }\n");
        Folder.Write("package/Editor/Probe.Editor.asmdef",
            """{ "name": "Probe.Editor", "references": [ "Probe.Runtime" ], "includePlatforms": [ "Editor" ] }""");
        Folder.Write("package/Editor/ProbeWindow.cs", "class ProbeWindow : UnityEditor.OnlyHere { static int Size => Probe.Size(2); }\n");
        return this;
    }

    /// <summary>The world with the repository's own package.</summary>
    public InstallationWorld WithRepository()
    {
        foreach (var part in new[] { "Runtime", "Editor" }) Folder.Copy(Repository.At(part), $"package/{part}");
        return this;
    }

    public InstallationWorld WithInstallation(string generation = "2022.3", string modules = $"{Data}/Managed/UnityEngine")
    {
        if (!Engines.TryGetValue(generation, out var engine))
            Engines[generation] = engine = Bytes(new Declarations(Repository.At("tests/csharp/UnityApi"), generation, Repository.Root)
                .Compile(SymbolSet.All[0], UnityVersion.Parse(generation)));
        File.WriteAllBytes(Folder.Write($"{modules}/UnityEngine.CoreModule.dll", ""), engine);
        Emit($"{modules}/UnityEditor.CoreModule.dll", "namespace UnityEditor { public class OnlyHere { } }");
        return this;
    }

    public InstallationWorld WithProject(string version = "2022.3.17f1")
    {
        foreach (var name in new[] { "Core.Runtime", "Core.Editor", "Universal.Runtime", "Universal.Editor" })
            Emit($"Project/Library/ScriptAssemblies/Unity.RenderPipelines.{name}.dll", $"public class Of{name.Replace(".", "")} {{ }}");
        Folder.Write("Project/ProjectSettings/ProjectVersion.txt",
                     $"m_EditorVersion: {version}\nm_EditorVersionWithRevision: {version} (4fc78088f837)\n");
        return this;
    }

    /// <summary>Writes an assembly of one source on .NET Standard.</summary>
    public void Emit(string file, string source) => File.WriteAllBytes(Folder.Write(file, ""), Bytes(CSharpCompilation.Create(
        Path.GetFileNameWithoutExtension(file), [CSharpSyntaxTree.ParseText(source)], [ApiCheck.Package.Profile.Reference],
        new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary))));

    public Commands Check(params string[] folders) => Commands.Run([.. folders, "--package", Package]);

    private static byte[] Bytes(Compilation compilation)
    {
        using var stream = new MemoryStream();
        var result = compilation.Emit(stream);
        Assert.That(result.Diagnostics.Where(diagnostic => diagnostic.Severity == DiagnosticSeverity.Error), Is.Empty);
        return stream.ToArray();
    }
}
