using System;
using System.Diagnostics;
using UnityEngine;
#if UNITY_EDITOR
using System.IO;
using PackageInfo = UnityEditor.PackageManager.PackageInfo;
#endif

namespace Penumbra
{
    /// <summary>
    /// Makes a component's help button open a page of this package's Documentation~, where the package is installed: the
    /// pages of this very version, also without a network. Unity takes any address that begins with file:///.
    /// </summary>
    [Conditional("UNITY_EDITOR")]
    [AttributeUsage(AttributeTargets.Class)]
    internal sealed class PackagePageAttribute : HelpURLAttribute
    {
        internal PackagePageAttribute(string page) : base(Address(page)) { }

        // Empty where the sources lie in a project's Assets: no package, no pages.
        private static string Address(string page)
        {
#if UNITY_EDITOR
            PackageInfo package = PackageInfo.FindForAssembly(typeof(PackagePageAttribute).Assembly);
            if (package != null)
                return new Uri(Path.Combine(package.resolvedPath, "Documentation~", page)).AbsoluteUri;
#endif
            return "";
        }
    }
}
