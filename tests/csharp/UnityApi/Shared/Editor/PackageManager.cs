using System.Reflection;

namespace UnityEditor.PackageManager;

public sealed partial class PackageInfo
{
    /// <summary>The place where the package that every assembly belongs to is said to be; null for none.</summary>
    [OwnBehaviour] public static string Installed { get; set; }

    internal PackageInfo() { }

    public string resolvedPath => Installed;

    public static PackageInfo FindForAssembly(Assembly assembly) => Installed == null ? null : new PackageInfo();
}
