namespace Penumbra.ApiCheck.Tests;

/// <summary>
/// The sources in which types are read, how they are named across sources, and what the package does with them.
/// </summary>
public sealed class SourceCheckTests
{
    private const string Shared = "tests/csharp/UnityApi/Shared";

    private SourceWorld world = null!;

    [SetUp]
    public void SetUp() => world = new SourceWorld();

    [TearDown]
    public void TearDown() => world.Dispose();

    private void Declare(string code, string from = "\"14.0.9\", \"universal\", \"Runtime/Thing.cs\"") =>
        world.Declare("Shared/Thing.cs", $"using Penumbra.UnityApi;\n[ReadFrom({from})]\n{code}\n");

    private void Problems(params string[] expected) => Assert.That(world.Check().Problems, Is.EqualTo(expected));

    [Test]
    public void ATypeOfAnotherSourceIsTold()
    {
        world.Real("core/Runtime/Thing.cs", "public class Thing { }");
        Declare("public class Thing { }");
        Problems($"{Shared}/Thing.cs:3:14: Thing: the source of universal has no such type, that of core has (see core/Runtime/Thing.cs:1)");
    }

    [Test]
    public void ATypeOfAnotherNamespaceIsTold()
    {
        world.Real("urp/Runtime/Thing.cs", "namespace UnityEngine { public class Thing { } }");
        Declare("public class Thing { }");
        Problems($"{Shared}/Thing.cs:3:14: Thing: the source of universal has no such type, but UnityEngine.Thing (see universal/Runtime/Thing.cs:1)");
    }

    [Test]
    public void AMisspeltTypeIsTold()
    {
        world.Real("urp/Runtime/Thing.cs", "namespace A.B { public class Things { } }");
        world.Declare("Shared/Thing.cs", "namespace A.B { [Penumbra.UnityApi.ReadFrom(\"14.0.9\", \"universal\", \"Runtime/Thing.cs\")] public class Thngs { } }");
        Problems($"{Shared}/Thing.cs:1:102: A.B.Thngs: the source of universal has no such type; the nearest is A.B.Things " +
                 "(see universal/Runtime/Thing.cs:1)");
    }

    [Test]
    public void AnotherFileIsTold()
    {
        world.Real("urp/Runtime/Other.cs", "public class Thing { }");
        Declare("public class Thing { }");
        Problems($"{Shared}/Thing.cs:3:14: Thing: [ReadFrom] names universal/Runtime/Thing.cs; it stands in universal/Runtime/Other.cs " +
                 "(see universal/Runtime/Other.cs:1)");
    }

    [Test]
    public void AMemberOfAnotherPartNamesItsOwnFile()
    {
        world.Real("urp/Runtime/Thing.cs", "public partial class Thing { }");
        world.Real("urp/Runtime/Part.cs", "public partial class Thing { public int a; public int b; }");
        Declare("public class Thing { [ReadFrom(\"14.0.9\", \"universal\", \"Runtime/Part.cs\")] public int a; public int b; }");
        Problems($"{Shared}/Thing.cs:3:100: Thing.b: [ReadFrom] names universal/Runtime/Thing.cs; it stands in universal/Runtime/Part.cs " +
                 "(see universal/Runtime/Part.cs:1)");
    }

    [Test]
    public void OfAPartialTypeTheNamedPartIsShown()
    {
        world.Real("urp/Runtime/Deprecated.cs", "public sealed partial class Thing { }");
        world.Real("urp/Runtime/Thing.cs", "public sealed partial class Thing { }");
        Declare("public class Thing { }");
        Problems($"{Shared}/Thing.cs:3:14: Thing: open here, sealed in the real source (see universal/Runtime/Thing.cs:1)");
    }

    [Test]
    public void ATypeWithoutOriginIsTold()
    {
        world.Declare("Shared/Thing.cs", "public class Thing { }");
        Problems($"{Shared}/Thing.cs:1:14: Thing: says of no source of 2022.3 where it was read: add [ReadFrom], or [OwnBehaviour] if it is ours");
    }

    [Test]
    public void AnOriginOfTheOtherGenerationDoesNotCount()
    {
        Declare("public class Thing { }", "\"17.0.3\", \"universal\", \"Runtime/Thing.cs\"");
        Problems($"{Shared}/Thing.cs:3:14: Thing: says of no source of 2022.3 where it was read: add [ReadFrom], or [OwnBehaviour] if it is ours");
    }

    private void MakeUnity65()
    {
        world.Real("engine/README.md", "## Unity 6000.5.2f1 C# reference source code\n");
        foreach (var (source, package) in new[] { ("core", "core"), ("urp", "universal") })
            world.Real($"{source}/package.json", $$"""{ "name": "com.unity.render-pipelines.{{package}}", "version": "17.5.0" }""");
    }

    [Test]
    public void ALaterGenerationTakesOverWhatTheEarlierOneSays()
    {
        MakeUnity65();
        world.Real("urp/Runtime/Thing.cs", "public class Thing { public int a; }");
        Declare("public class Thing { public int a; }", "\"17.0.3\", \"universal\", \"Runtime/Thing.cs\"");
        world.Declare("6000.0/Old.cs", "[Penumbra.UnityApi.ReadFrom(\"17.0.3\", \"universal\", \"Runtime/Old.cs\")] public class Old { }");
        world.Declare("6000.5/New.cs", "[Penumbra.UnityApi.ReadFrom(\"17.5.0\", \"universal\", \"Runtime/New.cs\")] public class New { }");
        world.Real("urp/Runtime/New.cs", "public class New { }");
        Assert.That(world.Check("6000.5").Problems,
                    Is.EqualTo(new[] { "tests/csharp/UnityApi/6000.0/Old.cs:1:84: Old: the source of universal has no such type" }));
        Assert.That(world.Check("6000.5").Sources.Single(source => source.Source == "universal").DeclaredFrom,
                    Is.EqualTo(new[] { "17.5.0" }));
    }

    [Test]
    public void ALaterGenerationsWordCounts()
    {
        MakeUnity65();
        world.Real("urp/Runtime/Moved.cs", "public class Thing { }");
        Declare("[ReadFrom(\"17.5.0\", \"universal\", \"Runtime/Moved.cs\")] public class Thing { }",
                "\"17.0.3\", \"universal\", \"Runtime/Thing.cs\"");
        Assert.That(world.Check("6000.5").Problems, Is.Empty);
    }

    [Test]
    public void OfTheExternalCodeUnitysOwnIsRead()
    {
        world.Real("engine/External/ScriptingCore/Unity.Scripting/Mark.cs", "public class Mark { }");
        world.Real("engine/External/Other/Alien.cs", "public class Alien { }");
        Declare("public class Mark { }", "\"2022.3.17f1\", \"engine\", \"External/ScriptingCore/Unity.Scripting/Mark.cs\"");
        Problems();
        Declare("public class Alien { }", "\"2022.3.17f1\", \"engine\", \"External/Other/Alien.cs\"");
        Problems($"{Shared}/Thing.cs:3:14: Alien: the source of engine has no such type");
    }

    [Test]
    public void ASourceThatIsNotGivenIsTold()
    {
        Declare("public class Thing { }");
        Directory.Delete(world.Folder.At("sources/urp"), recursive: true);
        Problems($"{Shared}/Thing.cs:3:14: Thing: was read in universal, which is not among the sources given");
    }

    [Test]
    public void TypesOfOtherSourcesAreFoundByName()
    {
        world.Real("engine/Runtime/Export/Map.cs", "namespace UnityEngine { public class Map { } internal class Hidden { } }");
        world.Real("core/Runtime/Handle.cs", "namespace UnityEngine.Rendering { public struct Handle { } public struct Map { } }");
        world.Real("urp/Runtime/Thing.cs", """
            using UnityEngine;
            using Grip = UnityEngine.Rendering.Handle;
            public class Thing { public Map map; public Grip grip; public Unity.Mathematics.float4 far; }
            """);
        world.Declare("Shared/Others.cs", """
            using Penumbra.UnityApi;
            namespace UnityEngine { [ReadFrom("2022.3.17f1", "engine", "Runtime/Export/Map.cs")] public class Map { } }
            namespace UnityEngine.Rendering { [ReadFrom("14.0.9", "core", "Runtime/Handle.cs")] public struct Handle { } }
            namespace Unity.Mathematics { [OwnBehaviour] public struct float4 { } }
            """);
        Declare("public class Thing { public UnityEngine.Map map; public UnityEngine.Rendering.Handle grip; public Unity.Mathematics.float4 far; }");
        var report = world.Check();
        Assert.That(report.Problems, Is.Empty);
        Assert.That(report.Types.Single(type => type.Name == "Thing").ByName, Is.EqualTo(new[] { "Unity.Mathematics.float4" }));
        Assert.That(report.Counts.Declarations, Is.EqualTo(6));
    }

    [Test]
    public void AnInterfaceThatThePackageImplementsMustBeWhole()
    {
        world.Real("urp/Runtime/Thing.cs", "public interface Thing { void Do(); int size { get; } bool Ask(int a) => true; }");
        Declare("public interface Thing { void Do(); }");
        Problems();
        world.Package("Runtime/Mine.cs", "class Mine : Thing { public void Do() { } }");
        Problems($"{Shared}/Thing.cs:3:18: Thing: the package has a type of it, which must have size: declare it (see universal/Runtime/Thing.cs:1)");
    }

    [Test]
    public void AnAbstractMemberOfABaseThatIsLeftOutIsToldToo()
    {
        world.Real("urp/Runtime/Thing.cs", """
            public abstract class Base { public abstract void Do(); public abstract void Done(); }
            public abstract class Thing : Base { public override void Done() { } }
            """);
        Declare("public abstract class Thing { }");
        world.Package("Runtime/Mine.cs", "class Mine : Thing { }");
        Problems($"{Shared}/Thing.cs:3:23: Thing: the package has a type of it, which must have Do(): declare it (see universal/Runtime/Thing.cs:1)");
    }

    [Test]
    public void WhatATypeInBetweenOverridesNeedNotBeDeclared()
    {
        world.Real("urp/Runtime/Thing.cs", """
            public abstract class Thing { public abstract void Do(); public abstract int size { get; } }
            public class Solid : Thing { public override void Do() { } public override int size => 1; }
            """);
        world.Declare("Shared/Things.cs", """
            using Penumbra.UnityApi;
            [ReadFrom("14.0.9", "universal", "Runtime/Thing.cs")] public abstract class Thing { }
            [ReadFrom("14.0.9", "universal", "Runtime/Thing.cs")] public class Solid : Thing { }
            """);
        world.Package("Runtime/Mine.cs", "class Mine : Solid { }");
        Problems();
        world.Package("Runtime/Mine.cs", "class Mine : Solid { } class Other : Thing { }");
        Problems($"{Shared}/Things.cs:2:77: Thing: the package has a type of it, which must have Do(): declare it (see universal/Runtime/Thing.cs:1)",
                 $"{Shared}/Things.cs:2:77: Thing: the package has a type of it, which must have size: declare it (see universal/Runtime/Thing.cs:1)");
    }

    [Test]
    public void ThePackageMustNotUseWhatIsOurs()
    {
        world.Real("urp/Runtime/Thing.cs", "public class Thing { }");
        Declare("public class Thing { [OwnBehaviour] public int Calls; }");
        world.Package("Runtime/Mine.cs", "class Mine\n{\n    int Get(Thing thing) => thing.Calls;\n}\n");
        Problems("Runtime/Mine.cs:3:35: Thing.Calls: ours, not Unity's: the package must not use it (see tests/csharp/UnityApi/Shared/Thing.cs:3)");
    }

    [Test]
    public void ThePackageMustNotUseWhatIsInternal()
    {
        world.Real("urp/Runtime/Thing.cs", "public class Thing { }");
        Declare("public class Thing { internal int Calls; }");
        world.Package("Runtime/Mine.cs", "class Mine\n{\n    int Get(Thing thing) => thing.Calls;\n}\n");
        Problems("Runtime/Mine.cs:3:35: Test.Runtime: CS0122 'Thing.Calls' is inaccessible due to its protection level");
    }

    [Test]
    public void ThePackageMustCompileInPlayersToo()
    {
        world.Real("urp/Editor/Thing.cs", "public class Thing { }");
        Declare("public class Thing { }", "\"14.0.9\", \"universal\", \"Editor/Thing.cs\"");
        world.Package("Runtime/Mine.cs", "#if !UNITY_EDITOR\nclass Mine : Missing { }\n#endif\n");
        Problems("Runtime/Mine.cs:2:14: Test.Runtime: CS0246 The type or namespace name 'Missing' could not be found (are you missing a using " +
                 "directive or an assembly reference?) [only under: player, player without XR]");
    }

    [Test]
    public void ThePackageMustNotUseTheEditorInPlayers()
    {
        world.Real("urp/Editor/Thing.cs", "public class Thing { public static int a; }");
        Declare("public class Thing { public static int a; }", "\"14.0.9\", \"universal\", \"Editor/Thing.cs\"");
        world.Package("Runtime/Mine.cs", "class Mine\n{\n#if UNITY_EDITOR\n    int a = Thing.a;\n#endif\n    int b = Thing.a;\n}\n");
        Problems($"Runtime/Mine.cs:6:13: Thing: the editor's: a player does not have it, put it under #if UNITY_EDITOR (see {Shared}/Thing.cs:3) " +
                 "[only under: player, player without XR]");
    }

    [Test]
    public void ThePackageMustKeepToNetStandard()
    {
        world.Package("Runtime/Mine.cs", "class Mine { float Get(float a) => System.MathF.ReciprocalEstimate(a); }");
        Problems("Runtime/Mine.cs:1:49: Test.Runtime: CS0117 'MathF' does not contain a definition for 'ReciprocalEstimate'");
    }

    [Test]
    public void ADeclarationThatDoesNotCompileIsTold()
    {
        Declare("public class Thing { public Missing a; }");
        world.Real("urp/Runtime/Thing.cs", "public class Thing { public int a; }");
        Assert.That(world.Check().Problems[0], Is.EqualTo(
            $"{Shared}/Thing.cs:3:29: declaration: CS0246 The type or namespace name 'Missing' could not be found (are you missing a using " +
            "directive or an assembly reference?)"));
    }

    [Test]
    public void ObsoleteWithAWarningIsNoted()
    {
        world.Real("urp/Runtime/Thing.cs", "public class Thing { [System.Obsolete(\"Use Other\")] public int a; }");
        Declare("public class Thing { public int a; }");
        var report = world.Check();
        Assert.That(report.Problems, Is.Empty);
        Assert.That(report.Types.Single().Obsolete, Is.EqualTo(new[] { "Thing.a" }));
    }
}
