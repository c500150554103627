using UnityEngine.Experimental.Rendering;

namespace Penumbra
{
    /// <summary>The source of a texture's size, before its divisor is applied.</summary>
    internal enum GraphExtent
    {
        /// <summary>The camera's target, with a slice per eye if two are drawn at once.</summary>
        Screen,

        /// <summary>The main light's shadow map, all cascades; shared by both eyes.</summary>
        Map,

        /// <summary>A cascade's tile of the map, with a layer per cascade.</summary>
        Tile,

        /// <summary>The texture's own width and height.</summary>
        Fixed,
    }

    /// <summary>A texture of a graph, as its manifest declares it: see docs/add-technique.md.</summary>
    internal struct GraphTexture
    {
        internal readonly string name;
        internal readonly GraphExtent extent;
        internal readonly GraphicsFormat format;

        /// <summary>Texels of the extent per texel of this texture, along each axis.</summary>
        internal readonly int divisor;

        /// <summary>Width of a texture with fixed extent; a depth above 1 makes a 3D texture.</summary>
        internal readonly int width;
        internal readonly int height;
        internal readonly int depth;

        /// <summary>Number of mip levels; 0: down to one texel.</summary>
        internal readonly int mips;

        internal readonly int layers;
        internal readonly int samples;

        /// <summary>
        /// The texture whose content of the previous frame this one has, 0 in the first frame; None where passes write
        /// it.
        /// </summary>
        internal int previousOf;

        internal GraphTexture(string name, GraphExtent extent, GraphicsFormat format, int divisor = 1, int width = 0,
                              int height = 0, int depth = 1, int mips = 1, int layers = 1, int samples = 1,
                              int previousOf = TechniqueGraph.None)
        {
            this.name = name;
            this.extent = extent;
            this.format = format;
            this.divisor = divisor;
            this.width = width;
            this.height = height;
            this.depth = depth;
            this.mips = mips;
            this.layers = layers;
            this.samples = samples;
            this.previousOf = previousOf;
        }
    }
}
