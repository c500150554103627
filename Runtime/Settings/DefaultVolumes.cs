#if UNITY_6000_0_OR_NEWER
using System.Collections.ObjectModel;
using UnityEngine.Rendering;

namespace Penumbra
{
    /// <summary>
    /// Unity 6: the Volume profiles of the URP asset and of scripts, which apply where no Volume of a scene does.
    /// Volume blending treats their values as defaults and drops their override states, so the profiles are read here.
    /// </summary>
    internal static class DefaultVolumes
    {
        internal static ShadowOptions Over(in ShadowOptions options)
        {
            VolumeManager manager = VolumeManager.instance;
            ShadowOptions over = Over(options, manager.qualityDefaultProfile);
            ReadOnlyCollection<VolumeProfile> custom = manager.customDefaultProfiles;
            for (int i = 0; custom != null && i < custom.Count; ++i) over = Over(over, custom[i]);
            return over;
        }

        private static ShadowOptions Over(in ShadowOptions options, VolumeProfile profile) =>
            profile != null && profile.TryGet(out PenumbraShadowsVolume volume) && volume.active ? volume.Over(options)
                                                                                                  : options;
    }
}
#endif
