namespace Penumbra.ApiCheck.Package;

/// <summary>
/// .NET Standard 2.1, the profile that Unity offers: the library under the declarations, the real sources and the
/// package alike, so that a type of System is one type in all of them. It lies beside this program.
/// </summary>
public static class Profile
{
    public static string File => Path.Combine(AppContext.BaseDirectory, "profile", "netstandard.dll");

    public static MetadataReference Reference { get; } = MetadataReference.CreateFromFile(File);
}
