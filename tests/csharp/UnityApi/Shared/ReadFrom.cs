using System;

namespace Penumbra.UnityApi
{
    /// <summary>
    /// Names where a declaration was read: the version of Unity ("engine") or of the package ("core", "universal"), and
    /// the file within its public source. `scripts/check-unity-api --source` reads it there again.
    /// </summary>
    [AttributeUsage(AttributeTargets.All, AllowMultiple = true, Inherited = false)]
    public sealed class ReadFromAttribute : Attribute
    {
        public ReadFromAttribute(string version, string source, string path) =>
            (Version, Source, Path) = (version, source, path);

        public string Version { get; }
        public string Source { get; }
        public string Path { get; }
    }

    /// <summary>
    /// Marks what is ours, not Unity's: a test looks at it or changes it. The package must not use it.
    /// </summary>
    [AttributeUsage(AttributeTargets.All, Inherited = false)]
    public sealed class OwnBehaviourAttribute : Attribute { }
}
