namespace Penumbra.ApiCheck.Tests;

/// <summary>The command's exit codes, what it writes where, and wrong usage.</summary>
public sealed class CommandTests
{
    private SourceWorld world = null!;

    [SetUp]
    public void SetUp()
    {
        world = new SourceWorld();
        world.Real("urp/Runtime/Thing.cs", "public class Thing { public int a; }");
        world.Declare("Shared/Thing.cs", "public class Thing { public int a; }");
    }

    [TearDown]
    public void TearDown() => world.Dispose();

    private Commands Run(params string[] more) => RunOf("2022.3", more);

    private Commands RunOf(string generation, params string[] more) => Commands.Run(
        ["--package", world.Folder.At("package"), "--generation", generation,
         .. world.Sources().SelectMany(one => new[] { "--" + one.Key, one.Value }), .. more]);

    [Test]
    public void NothingDiffers()
    {
        var run = Run();
        Assert.That(run.Answers, Is.EqualTo("1 types with 2 declarations, 0 differences from engine 2022.3.17f1, core 14.0.9, universal 14.0.9\n"));
        Assert.That((run.Code, run.Notes), Is.EqualTo((0, "")));
    }

    [Test]
    public void SomethingDiffers()
    {
        world.Real("urp/Runtime/Thing.cs", "public class Thing { public float a; }");
        var run = Run();
        Assert.That(run.Lines.Last(), Is.EqualTo("1 types with 2 declarations, 1 differences from engine 2022.3.17f1, core 14.0.9, universal 14.0.9"));
        Assert.That(run.Code, Is.EqualTo(1));
    }

    [Test]
    public void TheReportIsTheSameEachTimeAndNamesNoFolderOfTheMachine()
    {
        Run("--output", world.Folder.At("a.json"));
        Run("--output", world.Folder.At("b.json"));
        var text = File.ReadAllText(world.Folder.At("a.json"));
        Assert.That(File.ReadAllText(world.Folder.At("b.json")), Is.EqualTo(text));
        Assert.That(text, Does.Not.Contain(world.Folder.Path));
        var report = Report.SourceReport.Read(world.Folder.At("a.json"));
        Assert.That(report.Json(), Is.EqualTo(text));
        Assert.That(report.Types.Single().Files, Is.EqualTo(new[] { "universal/Runtime/Thing.cs" }));
    }

    [Test]
    public void AnotherDeclarationHasAnotherFingerprint()
    {
        var before = world.Check().Types.Single();
        world.Real("urp/Runtime/Thing.cs", "public class Thing { public long a; }");
        world.Declare("Shared/Thing.cs", "public class Thing { public long a; }");
        var after = world.Check().Types.Single();
        Assert.That(after.Declarations, Is.EqualTo(before.Declarations));
        Assert.That(after.Fingerprint, Is.Not.EqualTo(before.Fingerprint));
    }

    [Test]
    public void NestedTypesBelongToTheFingerprint()
    {
        string Fingerprint(string type)
        {
            world.Real("urp/Runtime/Thing.cs", $"public class Thing {{ public class Inner {{ public {type} a; }} }}");
            world.Declare("Shared/Thing.cs", $"public class Thing {{ public class Inner {{ public {type} a; }} }}");
            var report = world.Check();
            Assert.That((report.Counts.Differences, report.Counts.Declarations), Is.EqualTo((0, 3)));
            return report.Types.Single().Fingerprint;
        }

        Assert.That(Fingerprint("int"), Is.Not.EqualTo(Fingerprint("long")));
    }

    [Test]
    public void AReportThatCannotBeWrittenLeavesNothing()
    {
        var run = Run("--output", world.Folder.At("nowhere/a.json"));
        Assert.That(run.Notes, Is.EqualTo($"check-unity-api: {world.Folder.At("nowhere/a.json")}: the folder {world.Folder.At("nowhere")} does not exist\n"));
        Assert.That(run.Code, Is.EqualTo(2));
        Directory.CreateDirectory(world.Folder.At("taken"));
        Assert.That(Run("--output", world.Folder.At("taken")).Code, Is.EqualTo(2));
        Assert.That(Directory.EnumerateFiles(world.Folder.Path, "*", SearchOption.TopDirectoryOnly), Is.Empty);
    }

    [Test]
    public void TheGenerationMustFitTheEngine()
    {
        var run = RunOf("6000.0");
        Assert.That(run.Notes, Is.EqualTo("check-unity-api: the engine's source is of 2022.3.17f1: that is generation 2022.3, not 6000.0\n"));
        Assert.That(run.Code, Is.EqualTo(2));
    }

    [Test]
    public void ASourceSaysItsVersion()
    {
        world.Real("urp/package.json", "{\n  \"version\": oops\n}");
        Assert.That(Run().Notes, Does.StartWith($"check-unity-api: {world.Folder.At("sources/urp/package.json")}:2:14: no JSON: "));
        world.Real("urp/package.json", "{}");
        Assert.That(Run().Notes, Does.StartWith($"check-unity-api: {world.Folder.At("sources/urp/package.json")}:1:1: a field is missing"));
        File.Delete(world.Folder.At("sources/urp/package.json"));
        Assert.That(Run().Notes, Is.EqualTo(
            $"check-unity-api: {world.Folder.At("sources/urp")}: there is no package.json, which says the version of universal\n"));
        world.Real("engine/README.md", "Unity");
        Assert.That(Run().Notes, Is.EqualTo($"check-unity-api: {world.Folder.At("sources/engine/README.md")}:1:1: it says no version\n"));
    }

    [Test]
    public void DeclarationsMustBeThere()
    {
        var run = Run("--declarations", world.Folder.At("sources"));
        Assert.That(run.Notes, Is.EqualTo($"check-unity-api: {world.Folder.At("sources")}: no declarations in Shared/ or 2022.3/: --declarations DIR " +
                                          "names another folder\n"));
        Assert.That(run.Code, Is.EqualTo(2));
    }

    [TestCase("neither sources (--engine DIR) nor a folder of assemblies is given (--help says more)")]
    [TestCase("--generation 2022.3|6000.0|6000.5 says which declarations to check", "--engine", ".")]
    [TestCase("--generation 2022.3|6000.0|6000.5 says which declarations to check", "--engine", ".", "--generation", "5.6")]
    [TestCase("--engine needs a value (--help lists the options)", "--engine")]
    [TestCase("--sauce is not an option (--help lists them)", "--sauce", "a")]
    [TestCase("x: there is no such folder", "--engine", "x", "--generation", "2022.3")]
    [TestCase("--version does not go with --engine (--help says more)", "--engine", ".", "--generation", "2022.3", "--version", "6000.0")]
    [TestCase("--generation does not go with a folder of assemblies (--help says more)", ".", "--generation", "2022.3")]
    [TestCase("--declarations does not go with a folder of assemblies (--help says more)", ".", "--declarations", "a")]
    [TestCase("nowhere: there is no such folder", "nowhere")]
    [TestCase("'new' is not a version of Unity such as 2022.3.17f1 or 6000.0", ".", "--version", "new")]
    public void WrongUsageIsTold(string message, params string[] arguments)
    {
        var run = Commands.Run(["--package", world.Folder.At("package"), .. arguments]);
        Assert.That(run.Notes, Is.EqualTo($"check-unity-api: {message}\n"));
        Assert.That((run.Code, run.Answers), Is.EqualTo((2, "")));
    }

    [Test]
    public void HelpNamesEveryOption()
    {
        var run = Commands.Run("--help");
        Assert.That((run.Code, run.Notes), Is.EqualTo((0, "")));
        foreach (var option in new[] { "--generation", "--engine", "--core", "--universal", "--output",
                                       "--version", "--package", "--declarations", "--help" })
            Assert.That(run.Answers, Does.Contain(option));
    }
}
