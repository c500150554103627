using System;

namespace Penumbra.UnityApi
{
    /// <summary>
    /// Marks what is ours, not Unity's: a test looks at it or changes it. The package must not use it. All else is
    /// compared with Unity's public source by `scripts/check-unity-api --engine`.
    /// </summary>
    [AttributeUsage(AttributeTargets.All, Inherited = false)]
    public sealed class OwnBehaviourAttribute : Attribute { }
}
