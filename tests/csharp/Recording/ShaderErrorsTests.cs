using UnityEditor.Rendering;

namespace Penumbra.Tests;

/// <summary>The errors of the editor's compiler in the technique's shaders, by file and line.</summary>
public sealed class ShaderErrorsTests : FeatureTests
{
    [SetUp]
    public void SetUp()
    {
        AssetDatabase.Assets["Packages/com.penumbra.shadows/" + PenumbraShadows.ShaderFile] =
            Shader.Find(PenumbraShadows.ShaderName);
        feature.Settings.preset = QualityPreset.Low;
    }

    [TearDown]
    public void TearDown() => ShaderUtil.Messages.Clear();

    private static ShaderMessage Message(string text, string file, int line,
                                         ShaderCompilerMessageSeverity severity = ShaderCompilerMessageSeverity.Error) =>
        new ShaderMessage(text, severity) { file = file, line = line, platform = ShaderCompilerPlatform.D3D };

    private string Errors => FeatureSurroundings.Of(feature).shaderErrors;

    [Test]
    public void AKernelsErrorHasItsFileAndLine()
    {
        ShaderMessage warning = Message("signed division", "", 3, ShaderCompilerMessageSeverity.Warning);
        ShaderUtil.Messages[FakeShader.TiledPcss] = new[] { warning };
        Assert.That(Errors, Is.Null);
        ShaderUtil.Messages[FakeShader.TiledPcss] = new[]
        {
            warning, Message("undeclared identifier 'a'", "ShaderLibrary/ScreenTiles/TileDecision.hlsl", 12),
        };
        Assert.That(Errors, Is.EqualTo("ShaderLibrary/ScreenTiles/TileDecision.hlsl, line 12: undeclared identifier 'a' (D3D)"));
    }

    [Test]
    public void AnErrorOfThePassesIsOfTheAssetIfNoIncludeIsNamed()
    {
        PresetFallback.Choose(feature.Settings, QualityPreset.Low);
        ShaderUtil.Messages[Shader.Find(PenumbraShadows.ShaderName)] = new[] { Message("syntax error", "", 7) };
        Assert.That(Errors, Is.EqualTo(PenumbraShadows.ShaderFile + ", line 7: syntax error (D3D)"));
    }

    [Test]
    public void ShadersThatTheTechniqueDoesNotUseAreNotAsked()
    {
        ShaderUtil.Messages[FakeShader.Sums] = new[] { Message("syntax error", "", 7) };
        Assert.That(Errors, Is.Null);
    }

    /// <summary>An error is reported once for each API and keyword set.</summary>
    [Test]
    public void OfManyErrorsAFewAreSaidAndEachOnce()
    {
        ShaderUtil.Messages[FakeShader.TiledPcss] = new[]
        {
            Message("a", "", 1), Message("a", "", 1), Message("b", "", 2), Message("c", "", 3), Message("d", "", 4),
            Message("e", "", 5),
        };
        string[] lines = Errors.Split('\n');
        Assert.That(lines, Has.Length.EqualTo(4));
        Assert.That(lines[2], Does.Contain("line 3: c"));
        Assert.That(lines[3], Is.EqualTo("and 2 more"));
    }
}
