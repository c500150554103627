namespace Penumbra.ApiCheck.Tests;

/// <summary>
/// Each way in which a declaration can differ from the real source, with its whole message. The declaration stands on
/// line 5 of Shared/Thing.cs, the real one on line 4 of engine/Runtime/Export/Thing.cs.
/// </summary>
public sealed class DifferenceTests
{
    [TestCaseSource(typeof(Differences), nameof(Differences.All))]
    public void IsToldAtBothPlaces(Difference difference)
    {
        using var world = World(difference.Declared, difference.Real);
        Assert.That(world.Check().Problems, Is.EqualTo(difference.Messages));
    }

    [TestCaseSource(typeof(Differences), nameof(Differences.None))]
    public void IsNone(Difference same)
    {
        using var world = World(same.Declared, same.Real);
        var report = world.Check();
        Assert.That(report.Problems, Is.Empty);
        Assert.That(report.Counts.Types, Is.GreaterThan(0));
    }

    private static SourceWorld World(string declared, string real)
    {
        var world = new SourceWorld();
        world.Real("engine/Runtime/Export/Thing.cs", $"using System;\nnamespace UnityEngine\n{{\n{real}\n}}\n");
        world.Declare("Shared/Thing.cs", $$"""
            using System;
            using Penumbra.UnityApi;
            namespace UnityEngine
            {
            {{declared}}
            }
            """);
        return world;
    }
}
