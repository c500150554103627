namespace Penumbra.ApiCheck.Tests;

/// <summary>
/// The package as Unity compiles it for the build profile Meta Quest, whose symbol is UNITY_META_QUEST.
/// </summary>
public sealed class MetaQuestTests
{
    [TestCase("6000.5.2f1", true, true)]
    [TestCase("6000.4.0f1", true, true)]
    [TestCase("6000.3.0f1", true, false)]
    [TestCase("6000.5.2f1", false, false)]
    public void WhereReceiversDoNotReadTheTextureTheFeatureStandsAside(string version, bool quest, bool aside)
    {
        var unity = UnityVersion.Parse(version);
        var set = SymbolSet.All[0];
        var declarations = new Declarations(Repository.At("tests/csharp/UnityApi"), unity.Generation, Repository.Root);
        MetadataReference[] outside = [Profile.Reference, declarations.Compile(set, unity).ToMetadataReference()];
        var build = new PackageBuild(PackageSources.Read(Repository.Root), PackageVersions.Of(unity), set)
        {
            Symbols = quest ? ["UNITY_META_QUEST"] : [],
        };
        var compiled = build.Compile(_ => outside);
        Assert.That(compiled.SelectMany(one => PackageBuild.Errors(one)), Is.Empty);
        var runtime = compiled.Single(one => one.AssemblyName == "Penumbra.Runtime");
        Assert.That(Constant(runtime, "Penumbra.UrpFrame", "MetaQuest"), Is.EqualTo(aside));
        Assert.That(Constant(runtime, "Penumbra.PenumbraShadows", "RequiresScreenSpaceShadows"), Is.EqualTo(!aside));
    }

    private static object? Constant(Compilation compilation, string type, string field) =>
        compilation.GetTypeByMetadataName(type)!.GetMembers(field).OfType<IFieldSymbol>().Single().ConstantValue;
}
