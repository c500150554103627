using System.Collections.ObjectModel;

namespace Penumbra.Tests;

/// <summary>What the URP asset's Volume profile overrides holds where no Volume of the scene does.</summary>
public sealed class DefaultVolumesTests : FeatureTests
{
    [TearDown]
    public void RemoveTheProfiles()
    {
        VolumeManager.instance.qualityDefaultProfile = null;
        VolumeManager.instance.customDefaultProfiles = null;
    }

    private static VolumeProfile Profile(int filterSamples, bool active = true)
    {
        var volume = ScriptableObject.CreateInstance<PenumbraShadowsVolume>();
        volume.active = active;
        volume.filterSamples.Set(filterSamples);
        var profile = ScriptableObject.CreateInstance<VolumeProfile>();
        profile.components.Add(volume);
        return profile;
    }

    private static int Samples() => DefaultVolumes.Over(ShadowPresets.Options(QualityPreset.High)).filterSamples;

    [Test]
    public void TheAssetsProfileThenTheScripts()
    {
        Assert.That(Samples(), Is.EqualTo(ShadowPresets.Options(QualityPreset.High).filterSamples));
        VolumeManager.instance.qualityDefaultProfile = Profile(5);
        Assert.That(Samples(), Is.EqualTo(5));
        VolumeManager.instance.customDefaultProfiles =
            new ReadOnlyCollection<VolumeProfile>(new[] { Profile(6), null, Profile(7), Profile(8, active: false) });
        Assert.That(Samples(), Is.EqualTo(7));
    }

    [Test]
    public void AFrameHasThem()
    {
        VolumeManager.instance.qualityDefaultProfile = Profile(5);
        Render();
        Assert.That(Vector(urp.Device.Draws[0], "_PenumbraPcssAngularParameters0").y, Is.EqualTo(5.0f));
    }
}
