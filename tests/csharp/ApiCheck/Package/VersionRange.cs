using System.Globalization;
using System.Text.RegularExpressions;

namespace Penumbra.ApiCheck.Package;

/// <summary>
/// The version expressions of an asmdef's versionDefines, after Unity's manual, "Version defines": 14.0 is 14.0 and
/// later, [14.0] only that one, [14.0,17.0) the half-open range; empty is every version.
/// </summary>
public sealed partial class VersionRange
{
    private readonly Version? low, high;
    private readonly bool lowIn, highIn;

    private VersionRange(Version? low, bool lowIn, Version? high, bool highIn) =>
        (this.low, this.lowIn, this.high, this.highIn) = (low, lowIn, high, highIn);

    /// <summary>Parses a range; null where the expression is none.</summary>
    public static VersionRange? Parse(string expression)
    {
        var text = expression.Replace(" ", "");
        if (text.Length == 0) return new VersionRange(null, true, null, true);
        if (text[0] is not ('[' or '('))
            return Number(text) is { } least ? new VersionRange(least, true, null, true) : null;
        if (text[^1] is not (']' or ')'))
            return null;
        var bounds = text[1..^1].Split(',');
        var numbers = bounds.Select(bound => bound.Length == 0 ? null : Number(bound)).ToArray();
        if (bounds.Length > 2 || bounds.Where((bound, at) => bound.Length > 0 && numbers[at] is null).Any())
            return null;
        return new VersionRange(numbers[0], text[0] == '[', numbers[^1], text[^1] == ']');
    }

    public bool Holds(string version)
    {
        if (Number(version) is not { } number) return false;
        var above = low is null || number > low || (lowIn && number == low);
        var below = high is null || number < high || (highIn && number == high);
        return above && below;
    }

    /// <summary>
    /// The three numbers of a version, and as a fourth 0 for a pre-release (17.0.0-pre.1 comes before 17.0.0) and 1
    /// otherwise.
    /// </summary>
    private static Version? Number(string text)
    {
        var match = Pattern().Match(text);
        if (!match.Success) return null;
        int Part(int group) => match.Groups[group].Success
            ? int.Parse(match.Groups[group].Value, CultureInfo.InvariantCulture)
            : 0;
        return new Version(Part(1), Part(2), Part(3), match.Groups["pre"].Success ? 0 : 1);
    }

    [GeneratedRegex(@"^(\d{1,9})(?:\.(\d{1,9}))?(?:\.(\d{1,9}))?(?:[abfpx]\d+)?(?<pre>-[0-9A-Za-z.-]+)?$")]
    private static partial Regex Pattern();
}
