using System.Text.RegularExpressions;

namespace Penumbra.ApiCheck.Tests;

/// <summary>
/// The package against assemblies: layouts that are understood, errors that are found, what is missing.
/// </summary>
public sealed partial class InstallationTests
{
    private InstallationWorld world = null!;

    [SetUp]
    public void SetUp() => world = new InstallationWorld();

    [TearDown]
    public void TearDown() => world.Dispose();

    [TestCase("2022.3", "2022.3.17f1")]
    [TestCase("6000.0", "6000.0.23f1")]
    [TestCase("6000.5", "6000.5.2f1")]
    public void OurPackageCompiles(string generation, string version)
    {
        var run = world.WithRepository().WithInstallation(generation, $"{version}/Editor/Data").WithProject(generation, version)
            .Check(world.Folder.At(version), world.Project);
        Assert.That(run.Notes, Is.Empty);
        Assert.That(run.Lines, Has.Some.EqualTo($"Unity {version} by {world.Project}/ProjectSettings/ProjectVersion.txt, engine in " +
                                                $"{world.Folder.At(version)}/Editor/Data/Managed/UnityEngine"));
        Assert.That(run.Lines, Has.Some.Matches<string>(line => line.StartsWith("Penumbra.") && line.EndsWith(": 0 errors")));
        Assert.That(run.Code, Is.Zero);
    }

    [TestCase("2022.3")]
    [TestCase("6000.0")]
    [TestCase("6000.5")]
    public void AMisspeltMemberInOurPackageIsFound(string generation)
    {
        world.WithRepository();
        var (file, line, type, member) = Misspell();
        var run = world.WithInstallation(generation, "Unity/Editor/Data").WithProject(generation, generation + ".1f1").Check(world.Folder.At("Unity"), world.Project);
        var escaped = Regex.Escape($"{file}:{line}:");
        Assert.That(run.Lines.First(), Does.Match($@"^{escaped}\d+: error CS0117: '{type}' does not contain a definition for '{member}'$"));
        Assert.That(run.Code, Is.EqualTo(1));
    }

    [Test]
    public void AMemberThatUnityLacksIsFound()
    {
        var run = world.WithPackage().WithInstallation(without: "UnityEngine.Mathf.Clamp").WithProject().Check(world.Installation, world.Project);
        Assert.That(run.Lines.First(), Is.EqualTo("Runtime/Probe.cs:5:48: error CS0117: 'Mathf' does not contain a definition for 'Clamp'"));
        Assert.That(run.Lines, Has.Some.EqualTo("Probe.Editor, Probe.Runtime: 1 errors"));
        Assert.That(run.Code, Is.EqualTo(1));
    }

    [Test]
    public void AMemberThatOnlyPlayersLackIsFound()
    {
        world.WithPackage().WithInstallation().WithProject();
        world.Put(UnityAssemblies.Make("2022.3", "UnityEngine.Mathf.Clamp"), "2022.3.17f1/Editor/Data/PlaybackEngines/LinuxStandaloneSupport/Variations/mono/Managed",
            name => name == "UnityEngine.CoreModule");
        var run = world.Check(world.Installation, world.Project);
        Assert.That(run.Lines.First(), Is.EqualTo("Runtime/Probe.cs:5:48: error CS0117: 'Mathf' does not contain a definition for 'Clamp' [player only]"));
        Assert.That(run.Lines, Has.Some.EqualTo($"players: {world.Installation}/Editor/Data/PlaybackEngines/LinuxStandaloneSupport/Variations/mono/Managed"));
    }

    [TestCase("Unity.app/Contents", "")]
    [TestCase("Unity.app/Contents", "Unity.app")]
    [TestCase("Unity.app/Contents/Resources/Scripting", "")]
    [TestCase("Editor/Data", "")]
    [TestCase("Editor/Data", "Editor")]
    [TestCase("Editor/Data", "Editor/Data")]
    public void LayoutsOfInstallationsAreUnderstood(string data, string given)
    {
        world.WithPackage().WithInstallation(data: data).WithProject();
        File.Delete(world.Folder.At("Project/ProjectSettings/ProjectVersion.txt"));
        var onMac = data.StartsWith("Unity.app");
        if (onMac)
            world.Folder.Write("Unity.app/Contents/Info.plist", """
                <?xml version="1.0"?><plist version="1.0"><dict><key>LSMinimumSystemVersion</key><string>10.13.0</string>
                <key>CFBundleGetInfoString</key><string>Unity version 2022.3.17f1 (4fc78088f837).</string></dict></plist>
                """);
        var run = world.Check(world.Folder.At(given), world.Project);
        Assert.That(run.Notes, Is.Empty);
        Assert.That(run.Lines, Has.Some.StartsWith(onMac
            ? $"Unity 2022.3.17f1 by {world.Folder.At("Unity.app/Contents/Info.plist")}, engine in "
            : "Unity 2022.3 by the pipeline's API, engine in "));
        Assert.That(run.Lines, Has.Some.EqualTo($"class library: {world.Folder.At(data)}/NetStandard/ref/2.1.0"));
        Assert.That(run.Code, Is.Zero);
    }

    [Test]
    public void AFlatFolderIsUnderstood()
    {
        world.WithPackage().Put(UnityAssemblies.Make("2022.3"), "flat", _ => true);
        File.WriteAllText(world.Folder.At("flat/native.dll"), "not .NET");
        var run = world.Check(world.Folder.At("flat"));
        Assert.That(run.Notes, Is.Empty);
        Assert.That(run.Lines, Is.EqualTo(new[]
        {
            "Probe.Editor, Probe.Runtime: 0 errors",
            $"Unity 2022.3 by the pipeline's API, engine in {world.Folder.At("flat")}",
            "players: the editor's modules, as no build support is installed beside them",
            "class library: .NET Standard 2.1 of this program, as the folders hold none",
        }));
        Assert.That(run.Code, Is.Zero);
    }

    [TestCase("{ \"dependencies\": { \"com.unity.render-pipelines.universal\": { \"version\": \"17.0.3\" } } }", 1)]
    [TestCase("{ \"dependencies\": { \"com.unity.render-pipelines.universal\": { \"version\": \"14.0.9\" } } }", 0)]
    [TestCase("{ \"dependencies\": { \"com.unity.render-pipelines.universal\": { \"version\": \"file:../urp\" } } }", 0)]
    [TestCase("{ \"packages\": 1 }", 2)]
    [TestCase("{", 2)]
    public void TheProjectsLockFileDecidesVersionDefines(string locked, int code)
    {
        world.WithPackage().WithInstallation().WithProject();
        world.Folder.Write("package/Runtime/Graph.cs", "#if PROBE_GRAPH\nclass Graph : Missing { }\n#endif\n");
        world.Folder.Write("Project/Packages/packages-lock.json", locked);
        var run = world.Check(world.Installation, world.Project);
        Assert.That(run.Code, Is.EqualTo(code), run.Notes);
        Assert.That(run.Notes, code == 2 ? Does.StartWith($"check-unity-api: {world.Project}/Packages/packages-lock.json:1:") : Is.Empty);
    }

    [Test]
    public void ThePackagesThatTheInstallationBringsDecideThemElse()
    {
        world.WithPackage().WithInstallation().WithProject();
        world.Folder.Write("package/Runtime/Graph.cs", "#if PROBE_GRAPH\nclass Graph : Missing { }\n#endif\n");
        world.Folder.Write("2022.3.17f1/Editor/Data/Resources/PackageManager/BuiltInPackages/com.unity.render-pipelines.universal/package.json",
                           """{ "version": "17.0.3" }""");
        Assert.That(world.Check(world.Installation, world.Project).Lines.First(), Does.StartWith("Runtime/Graph.cs:2:15: error CS0246: "));
    }

    [Test]
    public void AnOlderClassLibraryServesWhereTheProfileIsMissing()
    {
        world.WithPackage().WithInstallation().WithProject();
        Directory.CreateDirectory(world.Folder.At("2022.3.17f1/Editor/Data/UnityReferenceAssemblies"));
        Directory.Move(world.Folder.At("2022.3.17f1/Editor/Data/NetStandard/ref/2.1.0"),
                       world.Folder.At("2022.3.17f1/Editor/Data/UnityReferenceAssemblies/unity-4.8-api"));
        var run = world.Check(world.Installation, world.Project);
        Assert.That(run.Lines, Has.Some.EqualTo($"class library: {world.Installation}/Editor/Data/UnityReferenceAssemblies/unity-4.8-api"));
        Assert.That(run.Code, Is.Zero);
    }

    [Test]
    public void WhatUnityCallsObsoleteIsNoted()
    {
        world.WithPackage().WithInstallation().WithProject();
        world.Folder.Write("package/Runtime/Old.cs", "static class Old\n{\n    [System.Obsolete(\"Gone\")] static int A;\n}\nstatic class New { static int B => OldOne.C; }\n" +
                           "[System.Obsolete(\"Gone\")] static class OldOne { public static int C = 1; }\n");
        var run = world.Check(world.Installation, world.Project);
        Assert.That(run.Lines, Has.Some.EqualTo("Runtime/Old.cs:5:36: warning CS0618: 'OldOne' is obsolete: 'Gone'"));
        Assert.That(run.Code, Is.Zero);
    }

    [Test]
    public void TheAnswerIsWrittenAsJson()
    {
        world.WithPackage().WithInstallation(without: "UnityEngine.Mathf.Clamp").WithProject();
        world.Check(world.Installation, world.Project, "--output", world.Folder.At("answer.json"));
        using var answer = System.Text.Json.JsonDocument.Parse(File.ReadAllText(world.Folder.At("answer.json")));
        Assert.That(answer.RootElement.GetProperty("problems").EnumerateArray().Select(problem => problem.GetString()),
                    Is.EqualTo(new[] { "Runtime/Probe.cs:5:48: error CS0117: 'Mathf' does not contain a definition for 'Clamp'" }));
        Assert.That(answer.RootElement.GetProperty("notes").GetArrayLength(), Is.EqualTo(4));
    }

    [Test]
    public void OnlyAssembliesThatTheAsmdefNamesAreSeen()
    {
        world.WithPackage().WithInstallation().WithProject();
        world.Put(new Dictionary<string, byte[]> { ["Unity.Other"] = UnityAssemblies.Emit("Unity.Other", "public class Other { }") },
                  "Project/Library/ScriptAssemblies", _ => true);
        world.Folder.Write("package/Runtime/Probe.cs", "public class Probe : Other { public static int Size(int a) => a; }\n");
        Assert.That(world.Check(world.Installation, world.Project).Lines, Has.Some.StartsWith("Runtime/Probe.cs:1:22: error CS0246: "));
        world.Folder.Write("package/Runtime/Probe.Runtime.asmdef", """{ "name": "Probe.Runtime", "references": [ "Unity.Other" ] }""");
        Assert.That(world.Check(world.Installation, world.Project).Lines.First(), Does.StartWith("Editor/ProbeWindow.cs:1:").And.Contain("error CS0012: "));
        world.Folder.Write("package/Editor/Probe.Editor.asmdef",
            """{ "name": "Probe.Editor", "references": [ "Probe.Runtime", "Unity.Other" ], "includePlatforms": [ "Editor" ] }""");
        Assert.That(world.Check(world.Installation, world.Project).Code, Is.Zero);
    }

    [Test]
    public void AReferenceByGuidIsRefused()
    {
        world.WithPackage().WithInstallation().WithProject();
        world.Folder.Write("package/Runtime/Probe.Runtime.asmdef", """{ "name": "Probe.Runtime", "references": [ "GUID:15fc0a57446b3144c949da3e2b9737a9" ] }""");
        var run = world.Check(world.Installation, world.Project);
        Assert.That(run.Notes, Is.EqualTo("check-unity-api: assemblies are missing:\n  GUID:15fc0a57446b3144c949da3e2b9737a9 (Probe.Runtime): a reference by GUID " +
                                          "cannot be followed here: refer to the assembly by its name\n"));
        Assert.That(run.Code, Is.EqualTo(3));
    }

    [Test]
    public void APackageOfWhichNothingIsCompiledIsNoSuccess()
    {
        world.WithPackage().WithInstallation().WithProject();
        Directory.Delete(world.Folder.At("package/Editor"), recursive: true);
        world.Folder.Write("package/Runtime/Probe.Runtime.asmdef", """{ "name": "Probe.Runtime", "defineConstraints": [ "NEVER" ] }""");
        var run = world.Check(world.Installation, world.Project);
        Assert.That(run.Lines.Take(3), Is.EqualTo(new[]
        {
            "no assembly of the package was compiled",
            "Probe.Runtime is not compiled for the editor: its constraint NEVER is not met",
            "Probe.Runtime is not compiled for the player: its constraint NEVER is not met",
        }));
        Assert.That(run.Code, Is.EqualTo(1));
    }

    [Test]
    public void AStaleAssemblyOfThePackageDoesNotStandInForIt()
    {
        world.WithPackage().WithInstallation().WithProject();
        world.Put(new Dictionary<string, byte[]> { ["Probe.Runtime"] = UnityAssemblies.Make("2022.3")["UnityEditor.CoreModule"] },
                  "Project/Library/ScriptAssemblies", _ => true);
        Assert.That(world.Check(world.Installation, world.Project).Code, Is.Zero);
    }

    [Test]
    public void AnInstallationAloneLacksThePipeline()
    {
        var run = world.WithPackage().WithInstallation().Check(world.Installation);
        Assert.That(run.Notes, Is.EqualTo(
            "check-unity-api: assemblies are missing:\n" +
            "  Unity.RenderPipelines.Core.Runtime.dll, to which Probe.Runtime refers: missing; Unity compiles it into " +
            "Library/ScriptAssemblies of a project that has the package: open one and name its folder too\n" +
            "  Unity.RenderPipelines.Universal.Runtime.dll, to which Probe.Runtime refers: missing; Unity compiles it into " +
            "Library/ScriptAssemblies of a project that has the package: open one and name its folder too\n"));
        Assert.That(run.Code, Is.EqualTo(3));
    }

    [Test]
    public void AProjectAloneLacksTheEngine()
    {
        var run = world.WithPackage().WithProject().Check(world.Project);
        Assert.That(run.Notes, Is.EqualTo(
            "check-unity-api: assemblies are missing:\n" +
            "  UnityEngine.CoreModule.dll: missing; it lies in Managed/UnityEngine of a Unity installation (Editor/Data, on macOS " +
            "Unity.app/Contents): name the installation's folder too\n" +
            "  UnityEditor.CoreModule.dll: missing; it lies in Managed/UnityEngine of a Unity installation (Editor/Data, on macOS " +
            "Unity.app/Contents): name the installation's folder too\n"));
        Assert.That(run.Code, Is.EqualTo(3));
    }

    [Test]
    public void AFileThatIsNoAssemblyIsMissing()
    {
        world.WithPackage().WithInstallation().WithProject();
        File.WriteAllText(world.Folder.At("Project/Library/ScriptAssemblies/Unity.RenderPipelines.Core.Runtime.dll"), "broken");
        var run = world.Check(world.Installation, world.Project);
        Assert.That(run.Notes, Does.Contain("Unity.RenderPipelines.Core.Runtime.dll, to which Probe.Runtime refers: the file in " +
                                            $"{world.Project}/Library/ScriptAssemblies is not a .NET assembly; "));
        Assert.That(run.Code, Is.EqualTo(3));
    }

    [Test]
    public void TwoVersionsAreRefused()
    {
        var run = world.WithPackage().WithInstallation().WithProject(version: "6000.0.23f1").Check(world.Installation, world.Project);
        Assert.That(run.Notes, Is.EqualTo(
            $"check-unity-api: two versions of Unity: 6000.0.23f1 in {world.Project}/ProjectSettings/ProjectVersion.txt, 2022.3.17f1 in " +
            $"{world.Installation}: --version says which one is meant\n"));
        Assert.That(run.Code, Is.EqualTo(2));
        Assert.That(world.Check(world.Installation, world.Project, "--version", "2022.3.17f1").Code, Is.Zero);
    }

    [Test]
    public void AnOlderUnityIsRefused()
    {
        var run = world.WithPackage().WithInstallation().WithProject().Check(world.Installation, world.Project, "--version", "2021.3.9f1");
        Assert.That(run.Notes, Is.EqualTo("check-unity-api: Unity 2021.3.9f1 (--version) is older than 2022.3, which the package needs\n"));
        Assert.That(run.Code, Is.EqualTo(2));
    }

    /// <summary>
    /// In the copy of our package the first use of a static member of Unity's mathematics gets a wrong letter.
    /// </summary>
    private (string File, int Line, string Type, string Member) Misspell()
    {
        foreach (var file in Directory.EnumerateFiles(world.Folder.At("package/Runtime"), "*.cs", SearchOption.AllDirectories).Order())
        {
            var text = File.ReadAllText(file);
            if (Use().Match(text) is not { Success: true } use) continue;
            File.WriteAllText(file, text.Insert(use.Index + use.Length, "x"));
            return (Path.GetRelativePath(world.Package, file), text[..use.Index].Count(letter => letter == '\n') + 1,
                    use.Groups[1].Value, use.Groups[2].Value + "x");
        }
        throw new AssertionException("no source in Runtime/ uses Unity's mathematics");
    }

    [GeneratedRegex(@"\b(Mathf|Matrix4x4|Vector[234])\.(\w+)")]
    private static partial Regex Use();
}
