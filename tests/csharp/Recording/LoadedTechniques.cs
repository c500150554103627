using System.Runtime.CompilerServices;

namespace Penumbra.Tests;

/// <summary>The package's file of techniques is loaded before any test, as the editor would load it.</summary>
internal static class LoadedTechniques
{
    internal static TextAsset File() => new TextAsset(Text());

    internal static string Text() =>
        System.IO.File.ReadAllText(Path.Combine(FakeShader.PackageRoot(), TechniqueTable.File));

    [ModuleInitializer]
    internal static void Load() => TechniqueTable.Load(File());
}
