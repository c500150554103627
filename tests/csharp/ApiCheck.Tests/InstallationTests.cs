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
    public void OurPackageCompilesAndAMisspeltMemberIsFound(string generation, string version)
    {
        world.WithRepository().WithInstallation(generation).WithProject(version);
        var run = world.Check(world.Installation, world.Project);
        Assert.That(run.Notes, Is.Empty);
        Assert.That(run.Lines, Has.Some.EqualTo($"Unity {version}, engine in {world.Installation}/Editor/Data/Managed/UnityEngine"));
        Assert.That(run.Lines, Has.Some.Matches<string>(line => line.StartsWith("Penumbra.") && line.EndsWith(": 0 errors")));
        Assert.That(run.Code, Is.Zero);

        var (file, line, type, member) = Misspell();
        run = world.Check(world.Installation, world.Project);
        var escaped = Regex.Escape($"{file}:{line}:");
        Assert.That(run.Lines.First(), Does.Match($@"^{escaped}\d+: error CS0117: '{type}' does not contain a definition for '{member}'$"));
        Assert.That(run.Code, Is.EqualTo(1));
    }

    [TestCase("2022.3.17f1/Editor/Data/Managed/UnityEngine", "2022.3.17f1")]
    [TestCase("Unity.app/Contents/Resources/Scripting/Managed/UnityEngine", "Unity.app")]
    [TestCase("Project/flat", "Project/flat")]
    public void AssembliesAreFoundInAnyLayout(string modules, string given)
    {
        world.WithPackage().WithInstallation(modules: modules).WithProject();
        world.Emit("Project/Library/Bee/Unity.RenderPipelines.Core.Runtime.dll", "public class Copy { }");
        world.Emit("Project/Library/ScriptAssemblies/Probe.Runtime.dll", "public class Stale { }");
        var run = world.Check(world.Folder.At(given), world.Project);
        Assert.That(run.Notes, Is.Empty);
        Assert.That(run.Lines, Is.EqualTo(new[]
        {
            "Probe.Editor, Probe.Runtime: 0 errors",
            $"Unity 2022.3.17f1, engine in {world.Folder.At(modules)}",
            "players: the editor's modules, as no build support is installed beside them",
        }));
        Assert.That(run.Code, Is.Zero);
    }

    [Test]
    public void WhatOnlyPlayersLackIsFound()
    {
        world.WithPackage().WithInstallation().WithProject();
        world.Folder.Write("package/Runtime/Probe.cs",
                           "public class Probe : UnityEditor.OnlyHere { public static int Size(int a) => UnityEngine.Mathf.Clamp(a, 1, 64); }\n");
        Assert.That(world.Check(world.Installation, world.Project).Lines.First(),
                    Does.StartWith("Runtime/Probe.cs:1:34: error CS0234: ").And.EndWith(" [player only]"));

        var player = $"{InstallationWorld.Data}/PlaybackEngines/LinuxStandaloneSupport/Variations/mono/Managed";
        world.WithPackage().Emit($"{player}/UnityEngine.CoreModule.dll", "namespace UnityEngine { public static class Mathf { } }");
        var run = world.Check(world.Installation, world.Project);
        Assert.That(run.Lines.First(), Is.EqualTo(
            "Runtime/Probe.cs:1:80: error CS0117: 'Mathf' does not contain a definition for 'Clamp' [player only]"));
        Assert.That(run.Lines, Has.Some.EqualTo($"players: {world.Folder.At(player)}"));
    }

    [Test]
    public void WhatUnityCallsObsoleteIsNoted()
    {
        world.WithPackage().WithInstallation().WithProject();
        world.Folder.Write("package/Runtime/Old.cs", "static class New { static int B => OldOne.C; }\n" +
                           "[System.Obsolete(\"Gone\")] static class OldOne { public static int C = 1; }\n");
        var run = world.Check(world.Installation, world.Project, "--output", world.Folder.At("answer.json"));
        Assert.That(run.Lines, Has.Some.EqualTo("Runtime/Old.cs:1:36: warning CS0618: 'OldOne' is obsolete: 'Gone'"));
        Assert.That(run.Code, Is.Zero);
        using var answer = System.Text.Json.JsonDocument.Parse(File.ReadAllText(world.Folder.At("answer.json")));
        Assert.That(answer.RootElement.GetProperty("notes").EnumerateArray().Select(note => note.GetString()), Is.EqualTo(run.Lines));
    }

    [Test]
    public void OnlyAssembliesThatTheAsmdefNamesAreSeen()
    {
        world.WithPackage().WithInstallation().WithProject().Emit("Project/Library/ScriptAssemblies/Unity.Other.dll", "public class Other { }");
        world.Folder.Write("package/Runtime/Probe.cs", "public class Probe : Other { public static int Size(int a) => a; }\n");
        Assert.That(world.Check(world.Installation, world.Project).Lines, Has.Some.StartsWith("Runtime/Probe.cs:1:22: error CS0246: "));
        world.Folder.Write("package/Runtime/Probe.Runtime.asmdef", """{ "name": "Probe.Runtime", "references": [ "Unity.Other" ] }""");
        Assert.That(world.Check(world.Installation, world.Project).Lines.First(), Does.StartWith("Editor/ProbeWindow.cs:1:").And.Contain("error CS0012: "));
        world.Folder.Write("package/Editor/Probe.Editor.asmdef",
            """{ "name": "Probe.Editor", "references": [ "Probe.Runtime", "Unity.Other" ], "includePlatforms": [ "Editor" ] }""");
        Assert.That(world.Check(world.Installation, world.Project).Code, Is.Zero);
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
    public void WhatIsMissingIsNamedWithItsPlace()
    {
        Directory.CreateDirectory(world.WithPackage().Project);
        var run = world.Check(world.Project, "--version", "2022.3.17f1");
        const string Of = ".dll, to which Probe.Runtime refers: Unity compiles it into " +
                          "Library/ScriptAssemblies of a project that has the package: open one and name its folder too\n";
        Assert.That(run.Notes, Is.EqualTo("check-unity-api: assemblies are missing:\n" +
            "  UnityEngine.CoreModule.dll: it lies in Managed/UnityEngine of a Unity installation: name the installation's folder too\n" +
            $"  Unity.RenderPipelines.Core.Runtime{Of}  Unity.RenderPipelines.Universal.Runtime{Of}"));
        Assert.That(run.Code, Is.EqualTo(3));
    }

    [Test]
    public void AFileThatIsNoAssemblyIsTold()
    {
        world.WithPackage().WithInstallation().WithProject().Folder.Write(
            "Project/Library/ScriptAssemblies/Unity.RenderPipelines.Core.Runtime.dll", "broken");
        Assert.That(world.Check(world.Installation, world.Project).Lines.First(), Does.StartWith("error CS0009: ").And.Contain("Core.Runtime.dll"));
    }

    [TestCase("Unity 2021.3.9f1 is older than 2022.3, which the package needs", "--version", "2021.3.9f1")]
    [TestCase("no folder is that of a project, which says the version of Unity: --version V says it")]
    public void AVersionIsNeeded(string message, params string[] options)
    {
        var run = world.WithPackage().WithInstallation().Check([world.Installation, .. options]);
        Assert.That((run.Code, run.Notes), Is.EqualTo((2, $"check-unity-api: {message}\n")));
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
