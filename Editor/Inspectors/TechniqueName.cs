using System.Reflection;
using UnityEngine;

namespace Penumbra.Editor
{
    /// <summary>What a technique is called everywhere: the name that the inspector's list has of it.</summary>
    internal static class TechniqueName
    {
        internal static string Of(ShadowTechnique technique) =>
            typeof(ShadowTechnique).GetField(technique.ToString()).GetCustomAttribute<InspectorNameAttribute>().displayName;
    }
}
