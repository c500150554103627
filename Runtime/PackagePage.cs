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
    /// Makes a component's help button open a page of the installed package's Documentation~ folder, so that the page
    /// matches this version and needs no network. Unity accepts any address that begins with file:///.
    /// </summary>
    [Conditional("UNITY_EDITOR")]
    [AttributeUsage(AttributeTargets.Class)]
    internal sealed class PackagePageAttribute : HelpURLAttribute
    {
        internal PackagePageAttribute(string page) : base(Address(page)) { }

        // The address is empty where the sources are in a project's Assets folder: then there is no package and no
        // documentation.
        private static string Address(string page)
        {
#if UNITY_EDITOR
            PackageInfo package = PackageInfo.FindForAssembly(typeof(PackagePageAttribute).Assembly);
            if (package != null) return new Uri(Path.Combine(package.resolvedPath, "Documentation~", page)).AbsoluteUri;
#endif
            return "";
        }
    }
}
