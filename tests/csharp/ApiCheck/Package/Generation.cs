namespace Penumbra.ApiCheck.Package;

/// <summary>
/// The versions of Unity that have a set of our declarations. A set holds for its own version and all later ones up to
/// the next set. That of 6000.5 takes over what 6000.0 declares, and says only what is different.
/// </summary>
public static class Generation
{
    private const string Unity2022 = "2022.3";
    private const string Unity6 = "6000.0";
    private const string Unity65 = "6000.5";

    public static readonly IReadOnlyList<string> All = [Unity2022, Unity6, Unity65];

    public static string Of(UnityVersion version) =>
        version.Major < 6000 ? Unity2022 : version is { Major: 6000, Minor: < 5 } ? Unity6 : Unity65;

    /// <summary>The folders of declarations.</summary>
    public static IReadOnlyList<string> Line(string generation) =>
        generation == Unity65 ? [Unity65, Unity6] : [generation];
}
