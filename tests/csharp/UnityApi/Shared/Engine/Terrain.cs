using UnityEngine.Experimental.Rendering;

namespace UnityEngine;

public sealed partial class Terrain : Behaviour
{
    public TerrainData terrainData { get; set; }
    public Material materialTemplate { get; set; }
    public bool drawInstanced { get; set; }
    public static Terrain[] activeTerrains { get; [OwnBehaviour] set; } = new Terrain[0];

    public Vector3 GetPosition() => transform.position;
}

/// <summary>Keeps heights as they were set; its texture has the format of the fake device.</summary>
public sealed partial class TerrainData : Object
{
    /// <summary>
    /// The format that heights are kept in: one channel, or two on devices without textures of 16 bits.
    /// </summary>
    [OwnBehaviour] public static GraphicsFormat Format { get; set; } = GraphicsFormat.R16_UNorm;

    [OwnBehaviour] public float[,] Heights { get; private set; }

    public TerrainData() { }

    public RenderTexture heightmapTexture => new RenderTexture { name = "heights", graphicsFormat = Format };
    public int heightmapResolution { get; set; } = 33;
    public Vector3 size { get; set; }

    public void SetHeights(int xBase, int yBase, float[,] heights) => Heights = heights;
}
