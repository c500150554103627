namespace Penumbra.ApiCheck.Assemblies;

/// <summary>
/// The Unity that the folders belong to, and the versions of the pipeline, with where they were read.
/// </summary>
public sealed record VersionSearch(UnityVersion Version, string From)
{
    private (int, int) Release => (Version.Major, Version.Minor);

    /// <param name="byApi">The last resort: the version that the assemblies' own API implies.</param>
    public static VersionSearch Find(UnityLayout layout, string? given, Func<UnityVersion> byApi)
    {
        var found = given is not null
            ? [new VersionSearch(UnityVersion.Parse(given), "--version")]
            : Candidates(layout).ToArray();
        var first = found.FirstOrDefault() ?? new VersionSearch(byApi(), "the pipeline's API");
        if (found.FirstOrDefault(other => other.Release != first.Release) is { } other)
            throw CheckException.Usage($"two versions of Unity: {first.Version.Text} in {first.From}, {other.Version.Text} in " +
                                       $"{other.From}: --version says which one is meant");
        if (first.Version.IsOlderThan(UnityVersion.Oldest))
            throw CheckException.Usage($"Unity {first.Version.Text} ({first.From}) is older than 2022.3, which the package " +
                                       "needs");
        return first;
    }

    /// <summary>
    /// Versions of packages, from a project's lock file, or else from the packages that the installation brings.
    /// </summary>
    public static IReadOnlyDictionary<string, string> Packages(UnityLayout layout)
    {
        var versions = new Dictionary<string, string>();
        foreach (var name in new[] { PackageVersions.Core, PackageVersions.Universal })
        {
            var manifest = Path.Combine(layout.Engine ?? "", "../../Resources/PackageManager/BuiltInPackages", name, "package.json");
            if (File.Exists(manifest) && JsonFile.Read(manifest, root => root.GetProperty("version").GetString()) is { } version)
                versions[name] = version;
        }
        var locks = layout.Given.Select(folder => Path.Combine(folder, "Packages", "packages-lock.json"));
        foreach (var file in locks.Where(File.Exists))
        {
            var locked = JsonFile.Read(file, root => root.GetProperty("dependencies").EnumerateObject()
                .Select(entry => (entry.Name, Version: entry.Value.GetProperty("version").GetString() ?? "")).ToArray());
            foreach (var (name, version) in locked.Where(entry => VersionRange.Parse(entry.Version) is not null))
                versions[name] = version;
        }
        return versions;
    }

    private static IEnumerable<VersionSearch> Candidates(UnityLayout layout)
    {
        foreach (var folder in layout.Given)
        {
            var project = Path.Combine(folder, "ProjectSettings", "ProjectVersion.txt");
            if (File.Exists(project) && UnityVersion.Find(File.ReadAllText(project)) is { } version)
                yield return new VersionSearch(version, project);
        }
        if (layout.Engine is null) yield break;
        // The Hub installs a version into a folder of its name; on macOS Info.plist names it too.
        for (var at = new DirectoryInfo(Path.GetFullPath(layout.Engine)); at is not null; at = at.Parent)
        {
            var plist = Path.Combine(at.FullName, "Info.plist");
            if (File.Exists(plist) && Released(File.ReadAllText(plist)) is { } version)
                yield return new VersionSearch(version, plist);
            if (UnityVersion.Find(at.Name) is { } named && named.Text == at.Name && named.Text.Count(one => one == '.') == 2)
                yield return new VersionSearch(named, at.FullName);
        }
    }

    /// <summary>The first version with three parts and a release letter: a plist holds other numbers too.</summary>
    private static UnityVersion? Released(string text) => text.Split('<', '>', ' ').Select(UnityVersion.Find)
        .FirstOrDefault(version => version is not null && version.Text.Any(char.IsLetter));
}
