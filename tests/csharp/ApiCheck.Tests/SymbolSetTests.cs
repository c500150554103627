namespace Penumbra.ApiCheck.Tests;

/// <summary>
/// A type or member under #if in the real source must stand under it in the declaration, or not be declared.
/// </summary>
public sealed class SymbolSetTests
{
    private const string Passes = """
        namespace UnityEngine.Rendering.Universal
        {
            public class Passes
            {
        #if UNITY_EDITOR
                public int edited;
        #endif
        #if ENABLE_VR && ENABLE_XR_MODULE
                public int views;
        #endif
        #if UNITY_6000_0_OR_NEWER
                public int graph;
        #endif
            }
        }
        """;

    private static string Declared(string members) => $$"""
        using Penumbra.UnityApi;
        namespace UnityEngine.Rendering.Universal
        {
            public class Passes
            {
        {{members}}
            }
        }
        """;

    [Test]
    public void AMemberOfTheEditorIsMissingInPlayers() => Differs("public int edited;",
        "UnityEngine.Rendering.Universal.Passes.edited: the real type has no such member (see universal/Runtime/Passes.cs:3) " +
        "[only under: player, player without XR]");

    [Test]
    public void AMemberOfXrIsMissingWithoutItsModule() => Differs("public int views;",
        "UnityEngine.Rendering.Universal.Passes.views: the real type has no such member (see universal/Runtime/Passes.cs:3) " +
        "[only under: editor without XR, player without XR]");

    [Test]
    public void AMemberOfTheNextVersionIsMissing() => Differs("public int graph;",
        "UnityEngine.Rendering.Universal.Passes.graph: the real type has no such member (see universal/Runtime/Passes.cs:3)");

    [Test]
    public void TheSameConditionsMakeItRight()
    {
        using var world = new SourceWorld();
        world.Real("urp/Runtime/Passes.cs", Passes);
        world.Declare("Shared/Passes.cs", Declared("""
            #if UNITY_EDITOR
            public int edited;
            #endif
            #if ENABLE_VR
            public int views;
            #endif
            #if UNITY_6000_0_OR_NEWER
            public int graph;
            #endif
            """));
        Assert.That(world.Check().Problems, Is.Empty);
    }

    [Test]
    public void ATypeOfAnEditorFolderIsLookedForInTheEditorOnly()
    {
        using var world = new SourceWorld();
        world.Real("urp/Editor/Window.cs", "namespace UnityEditor { public class Window { } }");
        world.Declare("Shared/Window.cs", """
            namespace UnityEditor
            {
                public class Window { }
            }
            """);
        var report = world.Check();
        Assert.That(report.Problems, Is.Empty);
        Assert.That(report.Types.Single().Only, Is.EqualTo(new[] { "editor", "editor without XR" }));
    }

    [Test]
    public void AnEditorFolderOfAPackageIsNotThereInPlayers()
    {
        using var world = new SourceWorld();
        world.Real("urp/Editor/Passes.cs", "namespace UnityEngine.Rendering.Universal { public class Passes { } }");
        world.Declare("Shared/Passes.cs", Declared(""));
        Assert.That(world.Check().Problems, Is.EqualTo(new[]
        {
            "tests/csharp/UnityApi/Shared/Passes.cs:4:18: UnityEngine.Rendering.Universal.Passes: no source has such a type: " +
            "mark it [OwnBehaviour] if it is ours [only under: player, player without XR]",
        }));
    }

    [Test]
    public void AsmdefSymbolsOfTheRealPackageCount()
    {
        using var world = new SourceWorld();
        world.Real("urp/Runtime/Unity.RenderPipelines.Universal.Runtime.asmdef", """
            {
                "name": "Unity.RenderPipelines.Universal.Runtime",
                "versionDefines": [
                    { "name": "com.unity.modules.physics2d", "expression": "1.0.0", "define": "USING_PHYSICS2D_MODULE" },
                    { "name": "com.unity.visualeffectgraph", "expression": "0.0.1", "define": "HAS_VFX_GRAPH" }
                ]
            }
            """);
        world.Real("urp/Runtime/Passes.cs", """
            namespace UnityEngine.Rendering.Universal
            {
                public class Passes
                {
            #if USING_PHYSICS2D_MODULE
                    public int flat;
            #endif
            #if HAS_VFX_GRAPH
                    public int graph;
            #endif
                }
            }
            """);
        world.Declare("Shared/Passes.cs", Declared("public int flat;\npublic int graph;"));
        Assert.That(world.Check().Problems, Is.EqualTo(new[]
        {
            "tests/csharp/UnityApi/Shared/Passes.cs:7:12: UnityEngine.Rendering.Universal.Passes.graph: the real type has no such " +
            "member (see universal/Runtime/Passes.cs:3)",
        }));
    }

    private static void Differs(string member, string message)
    {
        using var world = new SourceWorld();
        world.Real("urp/Runtime/Passes.cs", Passes);
        world.Declare("Shared/Passes.cs", Declared(member));
        Assert.That(world.Check().Problems, Is.EqualTo(new[] { $"tests/csharp/UnityApi/Shared/Passes.cs:6:12: {message}" }));
    }
}
