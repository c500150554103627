using System.Text;

namespace Penumbra.ApiCheck.Report;

/// <summary>The block of docs/unity-api.md that is written from the committed reports.</summary>
public static class Page
{
    private const string Begin = "<!-- api-check -->";
    private const string End = "<!-- /api-check -->";

    /// <summary>The page's text with the reports' figures between its two marks.</summary>
    public static string Written(string page, IReadOnlyList<SourceReport> reports)
    {
        var pieces = page.Split(Begin);
        if (pieces.Length != 2 || pieces[1].Split(End).Length != 2)
            throw CheckException.Usage($"the page needs {Begin} and {End} once each");
        return pieces[0] + Begin + "\n" + Table(reports) + End + pieces[1].Split(End)[1];
    }

    private static string Table(IReadOnlyList<SourceReport> reports)
    {
        var text = new StringBuilder();
        text.Append("| Unity | compared with | types | declarations | of which inherited | compared by name only | obsolete | differences |\n");
        text.Append("|:--|:--|--:|--:|--:|--:|--:|--:|\n");
        foreach (var report in reports)
        {
            var sources = report.Sources.Select(source => $"{source.Source} {source.Version} ({source.Files} files)");
            var counts = report.Counts;
            text.Append($"| {report.Generation} | {string.Join(", ", sources)} | {counts.Types} | {counts.Declarations} | ");
            text.Append($"{counts.Inherited} | {counts.ByName} | {counts.Obsolete} | {counts.Differences} |\n");
        }
        foreach (var report in reports)
        {
            Listed(text, $"Differences in {report.Generation}:", report.Problems);
            Listed(text, $"Obsolete in {report.Generation}, with a warning:", report.Types.SelectMany(type => type.Obsolete ?? []));
            Listed(text, $"Compared by name only in {report.Generation}:",
                   report.Types.SelectMany(type => type.ByName ?? []).Distinct());
        }
        return text.ToString();
    }

    private static void Listed(StringBuilder text, string title, IEnumerable<string> lines)
    {
        var all = lines.ToArray();
        if (all.Length == 0) return;
        text.Append('\n').Append(title).Append("\n\n");
        foreach (var line in all) text.Append("- ").Append(line.Replace("<", "\\<").Replace("|", "\\|")).Append('\n');
    }
}
