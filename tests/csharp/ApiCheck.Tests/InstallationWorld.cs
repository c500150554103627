namespace Penumbra.ApiCheck.Tests;

/// <summary>A Unity installation, a project and a small package on disk.</summary>
public sealed class InstallationWorld : IDisposable
{
    public TemporaryFolder Folder { get; } = new();

    public string Package => Folder.At("package");
    public string Project => Folder.At("Project");

    /// <summary>The folder that the Hub installs, of Windows and Linux.</summary>
    public string Installation => Folder.At("2022.3.17f1");

    public void Dispose() => Folder.Dispose();

    public InstallationWorld WithPackage()
    {
        Folder.Write("package/Runtime/Probe.Runtime.asmdef", """
            {
                "name": "Probe.Runtime",
                "references": [ "Unity.RenderPipelines.Core.Runtime", "Unity.RenderPipelines.Universal.Runtime" ],
                "versionDefines": [ { "name": "com.unity.render-pipelines.universal", "expression": "[17.0,18.0)", "define": "PROBE_GRAPH" } ]
            }
            """);
        Folder.Write("package/Runtime/Probe.cs", """
            using UnityEngine;

            public static class Probe
            {
                public static int Size(int value) => Mathf.Clamp(value, 1, 64);
            }
            """);
        Folder.Write("package/Editor/Probe.Editor.asmdef",
            """{ "name": "Probe.Editor", "references": [ "Probe.Runtime" ], "includePlatforms": [ "Editor" ] }""");
        Folder.Write("package/Editor/ProbeWindow.cs", "static class ProbeWindow { static int Size => Probe.Size(2); }\n");
        return this;
    }

    /// <summary>The world with the repository's own package.</summary>
    public InstallationWorld WithRepository()
    {
        foreach (var part in new[] { "Runtime", "Editor" }.Where(part => Directory.Exists(Repository.At(part))))
            Folder.Copy(Repository.At(part), $"package/{part}");
        return this;
    }

    public InstallationWorld WithInstallation(string generation = "2022.3", string data = "2022.3.17f1/Editor/Data", string? without = null)
    {
        Put(UnityAssemblies.Make(generation, without), $"{data}/Managed/UnityEngine", name => name.EndsWith("CoreModule", StringComparison.Ordinal));
        Directory.CreateDirectory(Folder.At($"{data}/NetStandard/ref/2.1.0"));
        File.Copy(ApiCheck.Package.Profile.File, Folder.At($"{data}/NetStandard/ref/2.1.0/netstandard.dll"));
        return this;
    }

    public InstallationWorld WithProject(string generation = "2022.3", string version = "2022.3.17f1")
    {
        Put(UnityAssemblies.Make(generation), "Project/Library/ScriptAssemblies", name => name.StartsWith("Unity.", StringComparison.Ordinal));
        Folder.Write("Project/ProjectSettings/ProjectVersion.txt",
            $"m_EditorVersion: {version}\nm_EditorVersionWithRevision: {version} (4fc78088f837)\n");
        return this;
    }

    public void Put(IReadOnlyDictionary<string, byte[]> assemblies, string folder, Func<string, bool> wanted)
    {
        Directory.CreateDirectory(Folder.At(folder));
        foreach (var (name, image) in assemblies.Where(entry => wanted(entry.Key)))
            File.WriteAllBytes(Folder.At($"{folder}/{name}.dll"), image);
    }

    public Commands Check(params string[] folders) => Commands.Run([.. folders, "--package", Package]);
}
