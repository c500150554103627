namespace Penumbra.Tests;

/// <summary>An option of a filter counts where the filter takes it and the options tell it.</summary>
public sealed class OptionEffectTests
{
    private static readonly (OptionField option, string[] fields)[] OfFilters =
    {
        (OptionFields.BlockerSamples, new[] { "blockerSamples", "searchSamples", "samples" }),
        (OptionFields.FilterSamples, new[] { "filterSamples" }),
        (OptionFields.SoftnessCap, new[] { "maxPenumbraMetres" }),
        (OptionFields.MinFilter, new[] { "minFilterTexels" }),
    };

    // The fields of the structure that a technique's filter takes; tents take none.
    private static string[] Fields(string structure) =>
        Measured.Named("structs", structure).GetProperty("fields").EnumerateArray()
            .Select(field => field.GetProperty("name").GetString()).ToArray();

    private static bool IsTold(ShadowOptions options, OptionField option)
    {
        object changed = options;
        FieldInfo field = typeof(ShadowOptions).GetField(option.name);
        field.SetValue(changed, field.FieldType == typeof(int) ? 7 : (object)3.5f);
        return !((ShadowOptions)changed).Parameters().Equals(options.Parameters());
    }

    [TestCase(ShadowTechnique.Tent3x3, null)]
    [TestCase(ShadowTechnique.Tent5x5, null)]
    [TestCase(ShadowTechnique.Tent7x7, null)]
    [TestCase(ShadowTechnique.Pcss, "PcssAngularParameters")]
    [TestCase(ShadowTechnique.PcssPoisson, "PcssClassicParameters")]
    [TestCase(ShadowTechnique.PcssHdrp, "PcssHdrpParameters")]
    [TestCase(ShadowTechnique.PcssBounded, "PcssBoundedParameters")]
    [TestCase(ShadowTechnique.TiledPcss, "PcssBoundedParameters")]
    public void IsThatOfTheFilter(ShadowTechnique technique, string structure)
    {
        string[] taken = structure == null ? new string[0] : Fields(structure);
        // Reference has no mask, so that the filter is alone.
        ShadowOptions options = ShadowPresets.Options(QualityPreset.Reference);
        options.technique = technique;
        foreach ((OptionField option, string[] fields) in OfFilters)
            Assert.That(option.Counts(options), Is.EqualTo(taken.Intersect(fields).Any() && IsTold(options, option)),
                        option.name);
    }
}
