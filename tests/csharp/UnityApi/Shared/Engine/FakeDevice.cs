namespace UnityEngine.Rendering;

/// <summary>The state that a GPU would see: global state, and every draw with the state it met.</summary>
[OwnBehaviour]
public sealed class FakeDevice
{
    public sealed class DrawCall
    {
        /// <summary>The name of the pass, or of the kernel.</summary>
        public string Pass;
        public int Vertices;
        public string Target;

        /// <summary>The viewport; null stands for all of the target.</summary>
        public Rect? Viewport;

        /// <summary>The fate of what the target holds.</summary>
        public RenderBufferLoadAction Load;

        /// <summary>The colour that a clear fills its target with.</summary>
        public Color Cleared;

        /// <summary>The numbers of a kernel's groups, or the buffer that has them.</summary>
        public string Groups;
        public Dictionary<string, object> Uniforms;
        public Dictionary<string, string> Textures;
        public SortedSet<string> Keywords, GlobalKeywords;

        /// <summary>Whether the editor may skip the draw until it has compiled the program.</summary>
        public bool CompilesAsynchronously;
    }

    public bool CompilesAsynchronously { get; set; } = true;

    public SortedSet<string> Keywords { get; } = new();
    public SortedSet<string> MaterialKeywords { get; } = new();
    public Dictionary<string, object> Uniforms { get; } = new();
    public Dictionary<string, string> Textures { get; } = new();
    public List<DrawCall> Draws { get; } = new();
    public List<string> Copies { get; } = new();
    public string Target { get; set; } = "camera";
    private RenderBufferLoadAction load;
    private Rect? viewport;

    /// <summary>Sets the target, with the whole of it as the viewport.</summary>
    public void SetTarget(string target, RenderBufferLoadAction loadAction)
    {
        Target = target;
        load = loadAction;
        viewport = null;
    }

    public void Clear(Color colour)
    {
        DrawCall clear = Call("clear", 0, null);
        clear.Cleared = colour;
        Draws.Add(clear);
    }

    public void SetViewport(Rect rect) => viewport = rect;

    public void SetKeyword(string name, bool value) => Set(Keywords, name, value);
    public void SetMaterialKeyword(string name, bool value) => Set(MaterialKeywords, name, value);

    public void Draw(string pass, int vertices) => Draws.Add(Call(pass, vertices, null));

    public void Dispatch(string kernel, string groups) => Draws.Add(Call(kernel, 0, groups));

    private DrawCall Call(string pass, int vertices, string groups) => new DrawCall
    {
        Pass = pass, Vertices = vertices, Groups = groups, Target = groups == null ? Target : null, Load = load,
        Viewport = groups == null ? viewport : null, Uniforms = new Dictionary<string, object>(Uniforms),
        Textures = new Dictionary<string, string>(Textures), Keywords = new SortedSet<string>(MaterialKeywords),
        GlobalKeywords = new SortedSet<string>(Keywords), CompilesAsynchronously = CompilesAsynchronously,
    };

    public void Play(CommandBuffer commands)
    {
        for (int i = 0; i < commands.Commands.Count; ++i) commands.Commands[i](this);
    }

    private static void Set(SortedSet<string> set, string name, bool value)
    {
        if (value) set.Add(name);
        else set.Remove(name);
    }
}
