namespace Penumbra.ApiCheck.Tests;

/// <summary>
/// The sources in which types are read, how they are named across sources, and what the package does with them.
/// </summary>
public sealed class SourceCheckTests
{
    private const string Shared = "tests/csharp/UnityApi/Shared";
    private const string NoSource = "no source has such a type: mark it [OwnBehaviour] if it is ours";

    private SourceWorld world = null!;

    [SetUp]
    public void SetUp() => world = new SourceWorld();

    [TearDown]
    public void TearDown() => world.Dispose();

    private void Declare(string code) => world.Declare("Shared/Thing.cs", $"using Penumbra.UnityApi;\n{code}\n");

    private void Problems(params string[] expected) => Assert.That(world.Check().Problems, Is.EqualTo(expected));

    [Test]
    public void ATypeOfAnotherNamespaceIsTold()
    {
        world.Real("urp/Runtime/Thing.cs", "namespace UnityEngine { public class Thing { } }");
        Declare("public class Thing { }");
        Problems($"{Shared}/Thing.cs:2:14: Thing: no source has such a type, but UnityEngine.Thing (see universal/Runtime/Thing.cs:1)");
    }

    [Test]
    public void AMisspeltTypeIsTold()
    {
        world.Real("urp/Runtime/Thing.cs", "namespace A.B { public class Things { } }");
        world.Declare("Shared/Thing.cs", "namespace A.B { public class Thngs { } }");
        Problems($"{Shared}/Thing.cs:1:30: A.B.Thngs: no source has such a type; the nearest is A.B.Things " +
                 "(see universal/Runtime/Thing.cs:1)");
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
        Declare("public class Thing { public int a; }");
        world.Declare("6000.0/Old.cs", "public class Old { }");
        world.Declare("6000.5/New.cs", "public class New { }");
        world.Real("urp/Runtime/New.cs", "public class New { }");
        Assert.That(world.Check("6000.5").Problems,
                    Is.EqualTo(new[] { $"tests/csharp/UnityApi/6000.0/Old.cs:1:14: Old: {NoSource}" }));
    }

    [Test]
    public void OfTheExternalCodeUnitysOwnIsRead()
    {
        world.Real("engine/External/ScriptingCore/Unity.Scripting/Mark.cs", "public class Mark { }");
        world.Real("engine/External/Other/Alien.cs", "public class Alien { }");
        Declare("public class Mark { }");
        Problems();
        Declare("public class Alien { }");
        Problems($"{Shared}/Thing.cs:2:14: Alien: {NoSource}");
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
            namespace UnityEngine { public class Map { } }
            namespace UnityEngine.Rendering { public struct Handle { } }
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
        Problems($"{Shared}/Thing.cs:2:18: Thing: the package has a type of it, which must have size: declare it (see universal/Runtime/Thing.cs:1)");
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
        Problems($"{Shared}/Thing.cs:2:23: Thing: the package has a type of it, which must have Do(): declare it (see universal/Runtime/Thing.cs:1)");
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
            public abstract class Thing { }
            public class Solid : Thing { }
            """);
        world.Package("Runtime/Mine.cs", "class Mine : Solid { }");
        Problems();
        world.Package("Runtime/Mine.cs", "class Mine : Solid { } class Other : Thing { }");
        Problems($"{Shared}/Things.cs:2:23: Thing: the package has a type of it, which must have Do(): declare it (see universal/Runtime/Thing.cs:1)",
                 $"{Shared}/Things.cs:2:23: Thing: the package has a type of it, which must have size: declare it (see universal/Runtime/Thing.cs:1)");
    }

    [Test]
    public void ThePackageMustNotUseWhatIsOurs()
    {
        world.Real("urp/Runtime/Thing.cs", "public class Thing { }");
        Declare("public class Thing { [OwnBehaviour] public int Calls; }");
        world.Package("Runtime/Mine.cs", "class Mine\n{\n    int Get(Thing thing) => thing.Calls;\n}\n");
        Problems("Runtime/Mine.cs:3:35: Thing.Calls: ours, not Unity's: the package must not use it (see tests/csharp/UnityApi/Shared/Thing.cs:2)");
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
        world.Package("Runtime/Mine.cs", "#if !UNITY_EDITOR\nclass Mine : Missing { }\n#endif\n");
        Problems("Runtime/Mine.cs:2:14: Test.Runtime: CS0246 The type or namespace name 'Missing' could not be found (are you missing a using " +
                 "directive or an assembly reference?) [only under: player, player without XR]");
    }

    [Test]
    public void ThePackageMustNotUseTheEditorInPlayers()
    {
        world.Real("urp/Editor/Thing.cs", "namespace UnityEditor { public class Thing { public static int a; } }");
        Declare("namespace UnityEditor { public class Thing { public static int a; } }");
        world.Package("Runtime/Mine.cs", "using UnityEditor;\nclass Mine\n{\n#if UNITY_EDITOR\n    int a = Thing.a;\n#endif\n    int b = Thing.a;\n}\n");
        Problems($"Runtime/Mine.cs:7:13: UnityEditor.Thing: the editor's: a player does not have it, put it under #if UNITY_EDITOR (see {Shared}/Thing.cs:2) " +
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
            $"{Shared}/Thing.cs:2:29: declaration: CS0246 The type or namespace name 'Missing' could not be found (are you missing a using " +
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
