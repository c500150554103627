namespace Penumbra.Tests;

/// <summary>The tests say where the feature and its Volume override are offered, and under which name.</summary>
public sealed class InspectorNamesTests
{
    private const string Title = "Penumbra Soft Shadows";

    [Test]
    public void TheFeaturesMenuTheVolumesMenuAndItsHeaderHaveOneName()
    {
        var feature = typeof(PenumbraShadows).GetCustomAttribute<DisallowMultipleRendererFeature>();
        var volume = typeof(PenumbraShadowsVolume).GetCustomAttribute<VolumeComponentMenu>();
        Assert.That(feature.customTitle, Is.EqualTo(Title));
        Assert.That(volume.menu, Is.EqualTo("Lighting/" + Title));
        Assert.That(new PenumbraShadowsVolumeEditor().GetDisplayTitle().text, Is.EqualTo(Title));
    }

    [Test]
    public void WhoOverridesTheTechniqueBeginsWithThatOfThePresets()
    {
        var volume = ScriptableObject.CreateInstance<PenumbraShadowsVolume>();
        Assert.That(volume.technique.value, Is.EqualTo(ShadowPresets.Options(volume.preset.value).technique));
    }

#if UNITY_6000_0_OR_NEWER
    [Test]
    public void OnlyTheUniversalRendererOffersTheFeature()
    {
        var supported = typeof(PenumbraShadows).GetCustomAttribute<SupportedOnRendererAttribute>();
        Assert.That(supported.rendererTypes, Is.EqualTo(new[] { typeof(UniversalRendererData) }));
    }
#endif
}
