namespace Penumbra.ApiCheck.Sources;

/// <summary>
/// Finds the three sources in the folders that the command names: a folder itself, or folders in it, two levels down
/// (DIR/engine; a checkout's Packages/com.unity.render-pipelines.core; a cache's
/// com.unity.render-pipelines.core@14.0.9).
/// </summary>
public static class SourceSearch
{
    private const int Depth = 2;

    /// <param name="named">Folders given for one source each.</param>
    /// <param name="versions">Versions given for sources that do not say their own.</param>
    public static IReadOnlyList<SourceFolder> Find(IEnumerable<string> folders, IReadOnlyDictionary<string, string> named,
                                                   IReadOnlyDictionary<string, string> versions)
    {
        var found = named.ToDictionary(entry => entry.Key, entry => entry.Value);
        foreach (var folder in folders)
        {
            if (!Directory.Exists(folder)) throw CheckException.Usage($"{folder}: there is no such folder");
            var inside = Search(folder, Depth).ToArray();
            if (inside.Length == 0)
                throw CheckException.Usage(
                    $"{folder}: neither Unity's C# reference (Runtime/Export, Editor/Mono) nor the package of core or URP is " +
                    "here or two folders down: name them with --engine, --core and --universal");
            foreach (var (source, root) in inside.Where(entry => !named.ContainsKey(entry.Source)))
            {
                if (found.TryGetValue(source, out var other) && Path.GetFullPath(other) != Path.GetFullPath(root))
                    throw CheckException.Usage($"two folders hold the source of {source}, {other} and {root}: name one with " +
                                               $"--{source}");
                found[source] = root;
            }
        }
        return [.. SourceFolder.All.Where(found.ContainsKey)
            .Select(source => SourceFolder.Open(source, found[source], versions.GetValueOrDefault(source)))];
    }

    private static IEnumerable<(string Source, string Root)> Search(string folder, int depth)
    {
        if (SourceFolder.Recognise(folder) is { } source) return [(source, folder)];
        return depth == 0
            ? []
            : Directory.EnumerateDirectories(folder).Order(StringComparer.Ordinal).SelectMany(inner => Search(inner, depth - 1));
    }
}
