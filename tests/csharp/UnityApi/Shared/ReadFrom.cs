using System;

namespace Penumbra.UnityApi
{
    /// <summary>
    /// Where a declaration was read: the version of Unity ("engine") or of the package ("core", "universal"), and
    /// the file within its public source. `scripts/check-unity-api --source` reads it there again.
    /// </summary>
    [AttributeUsage(AttributeTargets.All, AllowMultiple = true, Inherited = false)]
    public sealed class ReadFromAttribute : Attribute
    {
        public ReadFromAttribute(string version, string source, string path)
        {
            Version = version;
            Source = source;
            Path = path;
        }

        public string Version { get; }
        public string Source { get; }
        public string Path { get; }
    }

    /// <summary>Ours, not Unity's: what a test looks at or turns. The package must not use it.</summary>
    [AttributeUsage(AttributeTargets.All, Inherited = false)]
    public sealed class OwnBehaviourAttribute : Attribute
    {
    }
}
