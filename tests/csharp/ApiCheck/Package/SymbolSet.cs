namespace Penumbra.ApiCheck.Package;

/// <summary>
/// The preprocessor symbols of one kind of compilation: the editor or a player, with the XR and VR modules or in a
/// project that has switched them off. A declaration must hold under each set under which it is compiled.
/// </summary>
public sealed record SymbolSet(string Name, bool IsEditor, bool HasXr)
{
    public static readonly IReadOnlyList<SymbolSet> All =
    [
        new("editor", true, true),
        new("player", false, true),
        new("editor without XR", true, false),
        new("player without XR", false, false),
    ];

    /// <summary>The symbols of Unity itself on a desktop; what asmdef files add comes on top.</summary>
    public IEnumerable<string> Symbols(UnityVersion version)
    {
        string[] always =
        [
            "UNITY_STANDALONE", "UNITY_64", "ENABLE_MONO", "NET_STANDARD", "NET_STANDARD_2_0", "NET_STANDARD_2_1",
            "CSHARP_7_3_OR_NEWER", "ENABLE_LEGACY_INPUT_MANAGER", "ENABLE_PROFILER", "ENABLE_MULTIPLE_DISPLAYS",
        ];
        string[] editor = ["UNITY_EDITOR", "UNITY_EDITOR_64", "UNITY_ASSERTIONS", "ENABLE_UNITY_COLLECTIONS_CHECKS"];
        string[] xr = ["ENABLE_VR", "ENABLE_XR"];
        return version.Symbols().Concat(always).Concat(IsEditor ? editor : []).Concat(HasXr ? xr : []);
    }

    /// <summary>Whether a project of this set has the package or module that a versionDefine asks for.</summary>
    public bool HasModule(string package) => package switch
    {
        "com.unity.modules.vr" or "com.unity.modules.xr" => HasXr,
        _ => package.StartsWith("com.unity.modules.", StringComparison.Ordinal),
    };
}
