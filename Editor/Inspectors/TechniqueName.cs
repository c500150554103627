using System.Reflection;
using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>A technique's display name: its InspectorName.</summary>
    internal static class TechniqueName
    {
        internal static string Of(ShadowTechnique technique) =>
            typeof(ShadowTechnique).GetField(technique.ToString()).GetCustomAttribute<InspectorNameAttribute>().displayName;
    }
}
