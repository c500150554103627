namespace Penumbra.Tests;

/// <summary>The files of `penumbra bake`, as the component's inspector takes them.</summary>
public sealed class BakeFileTests
{
    // The file is as the program writes it.
    private const string Heights = @"{ ""kind"": ""height-field"", ""version"": 1, ""picture"": ""ground.png"",
            ""heights_metres"": [-12.5, 640], ""corner_metres"": [-100, 50], ""size_metres"": [1000, 2000],
            ""samples_without_surface"": 3 }";
        private const string Angles = @"{ ""kind"": ""horizon-angles"", ""version"": 1, ""pictures"": [""sky-0.png"", ""sky-1.png""],
            ""directions_degrees"": [0, 45, 90, 135, 180, 225, 270, 315], ""angles_degrees"": [0, 90],
            ""corner_metres"": [-100, 50], ""size_metres"": [1000, 2000] }";

    private FarShadowGround ground;

    [SetUp]
    public void SetUp()
    {
        ground = new GameObject("ground").AddComponent<FarShadowGround>();
        JsonUtility.Reader = FromJson;
    }

    // The result is as Unity's: null for an empty text, and ArgumentException for what is not JSON.
    private static object FromJson(string text, Type type)
    {
        try
        {
            return text == "" ? null
                              : JsonSerializer.Deserialize(text, type, new JsonSerializerOptions { IncludeFields = true });
        }
        catch (JsonException error)
        {
            throw new ArgumentException(error.Message);
        }
    }

    [TearDown]
    public void TearDown()
    {
        AssetDatabase.Assets.Clear();
        AssetImporter.Importers.Clear();
    }

    private static TextAsset File(string text, string path = "Assets/Far/bake.json")
    {
        var file = new TextAsset(text);
        AssetDatabase.Assets[path] = file;
        return file;
    }

    private static TextureImporter Picture(string path)
    {
        AssetDatabase.Assets[path] = new Texture2D { name = path };
        var importer = new TextureImporter();
        AssetImporter.Importers[path] = importer;
        return importer;
    }

    private static void WasImported(TextureImporter importer, TextureImporterFormat format)
    {
        Assert.That(importer.Imports, Is.EqualTo(1));
        Assert.That((importer.textureType, importer.textureShape, importer.alphaSource, importer.alphaIsTransparency),
                    Is.EqualTo((TextureImporterType.Default, TextureImporterShape.Texture2D,
                                TextureImporterAlphaSource.FromInput, false)));
        Assert.That((importer.sRGBTexture, importer.mipmapEnabled, importer.wrapMode, importer.npotScale),
                    Is.EqualTo((false, false, TextureWrapMode.Clamp, TextureImporterNPOTScale.None)));
        Assert.That((importer.Settings.format, importer.Settings.textureCompression, importer.Settings.maxTextureSize),
                    Is.EqualTo((format, TextureImporterCompression.Uncompressed, 16384)));
    }

    [Test]
    public void HeightsFillTheComponent()
    {
        TextureImporter picture = Picture("Assets/Far/ground.png");
        Assert.That(BakeAssignment.Assign(File(Heights), ground), Is.Null);
        Assert.That(ground.HeightMap, Is.SameAs(AssetDatabase.Assets["Assets/Far/ground.png"]));
        Assert.That(ground.CornerMetres, Is.EqualTo(new Vector2(-100.0f, 50.0f)));
        Assert.That(ground.SizeMetres, Is.EqualTo(new Vector2(1000.0f, 2000.0f)));
        Assert.That(ground.HeightsMetres, Is.EqualTo(new Vector2(-12.5f, 640.0f)));
        WasImported(picture, TextureImporterFormat.R16);
        Assert.That(EditorUtility.Dirty, Has.Member(ground));
    }

    [Test]
    public void AnglesFillTheComponentAndLeaveItsHeights()
    {
        Picture("Assets/Far/ground.png");
        BakeAssignment.Assign(File(Heights), ground);
        TextureImporter[] pictures = { Picture("Assets/Far/sky-0.png"), Picture("Assets/Far/sky-1.png") };
        Assert.That(BakeAssignment.Assign(File(Angles, "Assets/Far/sky.json"), ground), Is.Null);
        Assert.That(ground.HorizonFirst.name, Is.EqualTo("Assets/Far/sky-0.png"));
        Assert.That(ground.HorizonSecond.name, Is.EqualTo("Assets/Far/sky-1.png"));
        Assert.That(ground.HeightMap, Is.Not.Null);
        Assert.That(ground.HeightsMetres.y, Is.EqualTo(640.0f));
        foreach (TextureImporter picture in pictures) WasImported(picture, TextureImporterFormat.RGBA64);
    }

    [Test]
    public void PicturesOfAnotherAreaAreNotMixed()
    {
        Picture("Assets/Far/ground.png");
        BakeAssignment.Assign(File(Heights), ground);
        Picture("Assets/Far/sky-0.png");
        Picture("Assets/Far/sky-1.png");
        string problem = BakeAssignment.Assign(File(Angles.Replace("2000", "2001"), "Assets/Far/sky.json"), ground);
        Assert.That(problem, Does.Contain("Assets/Far/sky.json").And.Contain("another area").And.EndsWith("."));
        Assert.That(ground.HorizonFirst, Is.Null);
        Assert.That(ground.SizeMetres.y, Is.EqualTo(2000.0f));
    }

    [Test]
    public void AMissingPictureIsNamed()
    {
        Picture("Assets/Far/sky-0.png");
        string problem = BakeAssignment.Assign(File(Angles), ground);
        Assert.That(problem, Does.Contain("Assets/Far/sky-1.png"));
        Assert.That(ground.HorizonFirst, Is.Null, "all or nothing");
    }

    [TestCase("", "empty")]
    [TestCase("kind", "not JSON")]
    [TestCase("{}", "kind")]
    [TestCase("{ \"kind\": \"distance-field\", \"version\": 1 }", "distance-field")]
    [TestCase("{ \"kind\": \"height-field\", \"version\": 2 }", "version")]
    [TestCase("{ \"kind\": \"height-field\", \"version\": 1, \"picture\": \"a.png\" }", "corner_metres")]
    public void WhatIsNoBakeIsRefusedWithTheReason(string text, string reason)
    {
        Assert.That(BakeFile.Read(text, out BakeFile bake), Does.Contain(reason));
        Assert.That(bake, Is.Null);
    }

    [TestCase("ground.png", "")]
    [TestCase("ground.png", "../ground.png")]
    [TestCase("ground.png", "a\\\\b.png")]
    public void OnlyPicturesOfItsFolderAreRead(string name, string other) =>
        Assert.That(BakeFile.Read(Heights.Replace(name, other), out BakeFile _), Does.Contain("folder"));

    [Test]
    public void AngleFilesNameTwoPictures() =>
        Assert.That(BakeFile.Read(Angles.Replace(", \"sky-1.png\"", ""), out BakeFile _), Does.Contain("two pictures"));
}
