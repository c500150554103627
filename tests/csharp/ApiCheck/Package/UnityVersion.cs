using System.Globalization;
using System.Text.RegularExpressions;

namespace Penumbra.ApiCheck.Package;

/// <summary>
/// A version of Unity such as 2022.3.17f1, and the preprocessor symbols that Unity derives from it.
/// Releases up to 2023.3 and every 6000.x up to the version itself give an UNITY_X_Y_OR_NEWER each.
/// </summary>
public sealed partial record UnityVersion(int Major, int Minor, int Patch, string Text)
{
    public static readonly UnityVersion Oldest = Parse("2022.3.0f1");

    private static readonly (int Major, int First, int Last)[] Releases =
    [
        (5, 3, 6), (2017, 1, 4), (2018, 1, 4), (2019, 1, 4), (2020, 1, 3), (2021, 1, 3), (2022, 1, 3), (2023, 1, 3),
    ];

    /// <summary>The set of our declarations that stands for this version.</summary>
    public string Generation => Package.Generation.Of(this);

    public static UnityVersion Parse(string text) =>
        Find(text) ?? throw CheckException.Usage($"'{text}' is not a version of Unity such as 2022.3.17f1 or 6000.0");

    /// <summary>The first version that the text holds, null where it holds none.</summary>
    public static UnityVersion? Find(string text)
    {
        var match = Pattern().Match(text);
        if (!match.Success) return null;
        int Number(string group) => match.Groups[group].Success
            ? int.Parse(match.Groups[group].Value, CultureInfo.InvariantCulture)
            : 0;
        return new UnityVersion(Number("major"), Number("minor"), Number("patch"), match.Value);
    }

    public bool IsOlderThan(UnityVersion other) => (Major, Minor, Patch).CompareTo((other.Major, other.Minor, other.Patch)) < 0;

    public IEnumerable<string> Symbols()
    {
        yield return $"UNITY_{Major}";
        yield return $"UNITY_{Major}_{Minor}";
        yield return $"UNITY_{Major}_{Minor}_{Patch}";
        foreach (var (major, first, last) in Releases.Append((6000, 0, Major >= 6000 ? Minor : -1)))
        {
            for (var minor = first; minor <= last && (major, minor).CompareTo((Major, Minor)) <= 0; ++minor)
                yield return $"UNITY_{major}_{minor}_OR_NEWER";
        }
    }

    [GeneratedRegex(@"(?<![\d.])(?<major>20[12]\d|[6-9]\d{3})\.(?<minor>\d{1,2})(\.(?<patch>\d{1,4})([abfpx]\d+)?)?(?![\d.])")]
    private static partial Regex Pattern();
}
