using System.Reflection.Metadata;
using System.Reflection.PortableExecutable;

namespace Penumbra.ApiCheck.Assemblies;

/// <summary>A .NET assembly on disk, and the name that it is referred to by.</summary>
public sealed record ManagedFile(string File, string Name)
{
    /// <summary>Reads the file; null for a native library, or a file that is no library at all.</summary>
    public static ManagedFile? Read(string file)
    {
        try
        {
            using var stream = System.IO.File.OpenRead(file);
            using var image = new PEReader(stream);
            if (!image.HasMetadata) return null;
            var metadata = image.GetMetadataReader();
            if (!metadata.IsAssembly) return null;
            return new ManagedFile(file, metadata.GetString(metadata.GetAssemblyDefinition().Name));
        }
        catch (BadImageFormatException)
        {
            return null;
        }
    }

    public static IEnumerable<ManagedFile> In(string folder) =>
        Directory.EnumerateFiles(folder, "*.dll").Order(StringComparer.Ordinal).Select(Read).OfType<ManagedFile>();
}
