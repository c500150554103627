using UnityEditor.PackageManager;

namespace Penumbra.Tests;

/// <summary>A component's help button opens a page that ships, where the package is installed.</summary>
public sealed class PackagePageTests
{
    [TearDown]
    public void Uninstall() => PackageInfo.Installed = null;

    private static string Address(Type component)
    {
        var help = (HelpURLAttribute)component.GetCustomAttributes(typeof(HelpURLAttribute), true).Single();
        return help.URL;
    }

    [TestCase(typeof(PenumbraShadows))]
    [TestCase(typeof(PenumbraShadowsVolume))]
    public void LeadsToAFileOfTheInstalledPackage(Type component)
    {
        PackageInfo.Installed = FakeShader.PackageRoot();
        Assert.That(Address(component), Does.StartWith("file:///"));
        Assert.That(File.Exists(new Uri(Address(component)).LocalPath), Address(component));
    }

    [Test]
    public void IsAnAddressWhateverTheFoldersAreCalled()
    {
        PackageInfo.Installed = Path.GetFullPath("My Game/Library/PackageCache/com.penumbra.shadows@1.0 #2");
        string address = Address(typeof(PenumbraShadows));
        Assert.That(Uri.IsWellFormedUriString(address, UriKind.Absolute), address);
        Assert.That(new Uri(address).LocalPath, Does.EndWith("1.0 #2/Documentation~/renderer-feature.md"));
    }

    [Test]
    public void IsEmptyWhereTheSourcesAreNoPackage() => Assert.That(Address(typeof(PenumbraShadows)), Is.Empty);

    [Test]
    public void EveryComponentThatAnInspectorShowsHasOne()
    {
        foreach (Type type in typeof(PenumbraShadows).Assembly.GetTypes()
                     .Where(type => typeof(ScriptableObject).IsAssignableFrom(type) && !type.IsAbstract))
            Assert.That(type.GetCustomAttributes(typeof(HelpURLAttribute), true), Is.Not.Empty, type.Name);
    }
}
