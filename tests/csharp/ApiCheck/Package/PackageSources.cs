namespace Penumbra.ApiCheck.Package;

/// <summary>
/// The C# as Unity compiles it, by default what the package ships, Runtime/ and Editor/: each assembly definition with
/// its files, in the order in which they refer to each other. Unity ignores folders whose name ends with ~ or starts
/// with a full stop.
/// </summary>
public sealed class PackageSources
{
    private PackageSources(string root, IReadOnlyList<Asmdef> assemblies, IReadOnlyDictionary<string, Asmdef> owners) =>
        (Root, Assemblies, Owners) = (root, assemblies, owners);

    public string Root { get; }
    public IReadOnlyList<Asmdef> Assemblies { get; }

    private IReadOnlyDictionary<string, Asmdef> Owners { get; }

    public static PackageSources Read(string root) => Read(root, ["Runtime", "Editor"]);

    public static PackageSources Read(string root, IEnumerable<string> folders)
    {
        var files = folders.Select(folder => Path.Combine(root, folder)).Where(Directory.Exists).SelectMany(ShippedFiles.Below).ToArray();
        var assemblies = files.Where(file => file.EndsWith(".asmdef", StringComparison.Ordinal)).Select(Asmdef.Read).ToArray();
        if (assemblies.Length == 0)
            throw CheckException.Usage($"{root} holds no package: there is no .asmdef in Runtime/ or Editor/");
        if (assemblies.GroupBy(assembly => assembly.Name).FirstOrDefault(group => group.Count() > 1) is { } twice)
            throw CheckException.Usage($"{twice.Last().File}:1:1: the assembly {twice.Key} is defined twice, also in " +
                                       twice.First().File);
        var owners = new Dictionary<string, Asmdef>();
        foreach (var file in files.Where(file => file.EndsWith(".cs", StringComparison.Ordinal)))
            owners[file] = Owner(file, assemblies) ?? throw CheckException.Usage(
                $"{file}:1:1: no .asmdef in its folder or above: Unity does not compile this file in a package");
        return new PackageSources(root, InOrder(assemblies), owners);
    }

    public IEnumerable<SyntaxTree> Trees(Asmdef assembly, IEnumerable<string> symbols)
    {
        // Unity 2022.3 to 6000.5 compile C# 9.
        var options = new CSharpParseOptions(LanguageVersion.CSharp9, DocumentationMode.None, preprocessorSymbols: symbols);
        return Owners.Where(owner => owner.Value == assembly).Select(owner => owner.Key).Order(StringComparer.Ordinal)
            .Select(file => CSharpSyntaxTree.ParseText(File.ReadAllText(file), options, Shown(file)));
    }

    private string Shown(string file) => Path.GetRelativePath(Root, file).Replace('\\', '/');

    private static Asmdef? Owner(string file, IEnumerable<Asmdef> assemblies) =>
        assemblies.Where(assembly => file.StartsWith(assembly.Folder + Path.DirectorySeparatorChar, StringComparison.Ordinal))
            .MaxBy(assembly => assembly.Folder.Length);

    private static List<Asmdef> InOrder(IReadOnlyList<Asmdef> assemblies)
    {
        var ordered = new List<Asmdef>();
        var open = new HashSet<Asmdef>();
        void Add(Asmdef assembly)
        {
            if (ordered.Contains(assembly)) return;
            if (!open.Add(assembly))
                throw CheckException.Usage($"{assembly.File}:1:1: {assembly.Name} refers to itself through its references");
            foreach (var other in assemblies.Where(other => assembly.References.Contains(other.Name))) Add(other);
            ordered.Add(assembly);
        }

        foreach (var assembly in assemblies) Add(assembly);
        return ordered;
    }
}

/// <summary>The files of a folder that Unity would import.</summary>
public static class ShippedFiles
{
    public static IEnumerable<string> Below(string folder)
    {
        foreach (var file in Directory.EnumerateFiles(folder).Order(StringComparer.Ordinal)) yield return file;
        foreach (var inner in Directory.EnumerateDirectories(folder).Order(StringComparer.Ordinal))
        {
            var name = Path.GetFileName(inner);
            // A link may lead back to a folder above.
            if (name.EndsWith('~') || name.StartsWith('.') || new DirectoryInfo(inner).LinkTarget is not null) continue;
            foreach (var file in Below(inner)) yield return file;
        }
    }
}
