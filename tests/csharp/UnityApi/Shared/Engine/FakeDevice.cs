using System.Collections.Generic;
using Penumbra.UnityApi;

namespace UnityEngine.Rendering
{
    /// <summary>What the GPU would see: global state, and every draw with the state it met.</summary>
    [OwnBehaviour]
    public sealed class FakeDevice
    {
        public sealed class DrawCall
        {
            public string Pass;
            public int Vertices;
            public string Target;
            public Dictionary<string, object> Uniforms;
            public Dictionary<string, string> Textures;
            public SortedSet<string> Keywords;
        }

        public SortedSet<string> Keywords { get; } = new SortedSet<string>();
        public SortedSet<string> MaterialKeywords { get; } = new SortedSet<string>();
        public Dictionary<string, object> Uniforms { get; } = new Dictionary<string, object>();
        public Dictionary<string, string> Textures { get; } = new Dictionary<string, string>();
        public List<DrawCall> Draws { get; } = new List<DrawCall>();
        public string Target { get; set; } = "camera";

        public void SetKeyword(string name, bool value) => Set(Keywords, name, value);
        public void SetMaterialKeyword(string name, bool value) => Set(MaterialKeywords, name, value);

        public void Draw(string pass, int vertices)
        {
            Draws.Add(new DrawCall
            {
                Pass = pass,
                Vertices = vertices,
                Target = Target,
                Uniforms = new Dictionary<string, object>(Uniforms),
                Textures = new Dictionary<string, string>(Textures),
                Keywords = new SortedSet<string>(MaterialKeywords),
            });
        }

        public void Play(CommandBuffer commands)
        {
            foreach (System.Action<FakeDevice> command in commands.Commands) command(this);
        }

        private static void Set(SortedSet<string> set, string name, bool value)
        {
            if (value) set.Add(name);
            else set.Remove(name);
        }
    }
}
