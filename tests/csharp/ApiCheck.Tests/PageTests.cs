namespace Penumbra.ApiCheck.Tests;

/// <summary>The block that is written into a page.</summary>
public sealed class PageTests
{
    private static readonly SourceReport Report = new()
    {
        Generation = "2022.3",
        Sources = [new("engine", "2022.3.17f1", "README.md", 3, ["2022.3.17f1"]), new("core", "14.0.9", "package.json", 2, [])],
        SymbolSets = ["editor"],
        Counts = new(2, 7, 1, 1, 1, 1),
        Types =
        [
            new("A<T>", "engine", ["engine/A.cs"], 5, "0123456789abcdef") { Obsolete = ["A<T>.Old()"], ByName = ["B.C"] },
            new("D", "core", ["core/D.cs"], 2, "0123456789abcdef") { ByName = ["B.C"] },
        ],
        Problems = ["A.cs:1:2: A<T>.a: missing"],
    };

    [Test]
    public void HoldsTheFigures() => Assert.That(Page.Written("before\n<!-- api-check -->\nold\n<!-- /api-check -->\nafter\n", [Report]), Is.EqualTo("""
        before
        <!-- api-check -->
        | Unity | compared with | types | declarations | of which inherited | compared by name only | obsolete | differences |
        |:--|:--|--:|--:|--:|--:|--:|--:|
        | 2022.3 | engine 2022.3.17f1 (3 files), core 14.0.9 (2 files) | 2 | 7 | 1 | 1 | 1 | 1 |

        Differences in 2022.3:

        - A.cs:1:2: A\<T>.a: missing

        Obsolete in 2022.3, with a warning:

        - A\<T>.Old()

        Compared by name only in 2022.3:

        - B.C
        <!-- /api-check -->
        after

        """));

    [TestCase("no marks")]
    [TestCase("<!-- api-check --> <!-- api-check --> <!-- /api-check -->")]
    [TestCase("<!-- /api-check --> <!-- api-check -->")]
    public void ThePageNeedsItsMarks(string page) => Assert.That(
        Assert.Throws<CheckException>(() => Page.Written(page, [Report]))!.Message,
        Is.EqualTo("the page needs <!-- api-check --> and <!-- /api-check --> once each"));

    [Test]
    public void TheCommandWritesIt()
    {
        using var folder = new TemporaryFolder();
        var page = folder.Write("a.md", "<!-- api-check -->\n<!-- /api-check -->\n");
        var report = folder.Write("a.json", Report.Json());
        Assert.That(Commands.Run("--page", page, report), Is.EqualTo(new Commands(0, "", "")));
        Assert.That(File.ReadAllText(page), Is.EqualTo(Page.Written("<!-- api-check -->\n<!-- /api-check -->\n", [Report])));
    }

    [Test]
    public void AReportThatIsNoneIsTold()
    {
        using var folder = new TemporaryFolder();
        var page = folder.Write("a.md", "<!-- api-check -->\n<!-- /api-check -->\n");
        var run = Commands.Run("--page", page, folder.Write("a.json", "{\n  \"generation\": 1 }"));
        Assert.That(run.Notes, Does.StartWith($"check-unity-api: {folder.At("a.json")}:2:").And.Contain(": no report: "));
        Assert.That(run.Code, Is.EqualTo(2));
    }
}
