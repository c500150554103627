namespace Penumbra.ApiCheck.Package;

/// <summary>The versions of Unity and of the packages that versionDefines ask about.</summary>
public sealed record PackageVersions(UnityVersion Unity, IReadOnlyDictionary<string, string> Packages)
{
    public const string Core = "com.unity.render-pipelines.core";
    public const string Universal = "com.unity.render-pipelines.universal";

    /// <summary>
    /// The versions with the pipeline's version that came with this Unity, where none is known better.
    /// </summary>
    public static PackageVersions Of(UnityVersion unity, IReadOnlyDictionary<string, string>? known = null)
    {
        // Each release of Unity since 2021.2 comes with one version of the pipeline: 2022.3 with 14.0, 6000.N with
        // 17.N.
        var pipeline = unity.Major >= 6000 ? $"17.{unity.Minor}.0" : unity.Minor >= 3 ? "14.0.0" : "13.0.0";
        if (unity.Major == 2023) pipeline = $"{14 + unity.Minor}.0.0";
        var packages = new Dictionary<string, string> { [Core] = pipeline, [Universal] = pipeline };
        foreach (var (name, version) in known ?? new Dictionary<string, string>()) packages[name] = version;
        return new PackageVersions(unity, packages);
    }

    /// <summary>The symbols that an asmdef's versionDefines give under a symbol set.</summary>
    public IEnumerable<string> Symbols(Asmdef asmdef, SymbolSet set) =>
        from define in asmdef.VersionDefines
        let version = VersionOf(define.Package, set)
        where version is not null && define.Range.Holds(version)
        select define.Symbol;

    private string? VersionOf(string package, SymbolSet set)
    {
        if (package == "Unity") return Unity.Text;
        if (Packages.TryGetValue(package, out var version)) return version;
        return set.HasModule(package) ? "1.0.0" : null;
    }
}
