using UnityEngine;

namespace Penumbra
{
    /// <summary>Bits of each channel of the maps of filtered techniques. Assets store these numbers.</summary>
    public enum MapFormat
    {
        [InspectorName("32 bits")]
        Bits32 = 0,

        /// <summary>
        /// This format needs half of the memory and bandwidth, and has more light bleeding or more fading at contacts.
        /// </summary>
        [InspectorName("16 bits")]
        Bits16 = 1,
    }
}
