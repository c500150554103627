using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Penumbra
{
    /// <summary>
    /// The materials of the shaders that passes draw with: the feature's own, and one for each other shader.
    /// </summary>
    internal sealed class PassMaterials : IDisposable
    {
        private readonly Material own;
        private readonly PassAssets assets;
        private readonly Dictionary<Object, Material> others = new Dictionary<Object, Material>();

        /// <param name="own">The material of PenumbraShadows.ShaderFile.</param>
        internal PassMaterials(Material own, PassAssets assets)
        {
            this.own = own;
            this.assets = assets;
        }

        /// <summary>
        /// Finds the pass's asset, and for a raster pass the material. Returns what is missing, or null.
        /// </summary>
        internal string Find(GraphPass pass, out Object asset, out Material material)
        {
            material = pass.asset == PenumbraShadows.ShaderFile ? own : null;
            asset = material != null ? material.shader : assets.Of(pass.asset);
            if (asset == null) return pass.asset + " is missing";
            if (pass.kind == PassKind.Compute) return Problem(pass, asset as ComputeShader);
            if (!(asset is Shader shader)) return pass.asset + " is not a shader";
            if (!shader.isSupported) return pass.asset + " does not compile for this platform";
            if (material == null) material = Other(shader);
            return null;
        }

        private static string Problem(GraphPass pass, ComputeShader kernels)
        {
            if (kernels == null) return pass.asset + " is not a compute shader";
            return SystemInfo.supportsComputeShaders
                       ? null : pass.asset + " is a compute shader, which this device does not support";
        }

        private Material Other(Shader shader)
        {
            if (!others.TryGetValue(shader, out Material material))
                others[shader] = material = CoreUtils.CreateEngineMaterial(shader);
            return material;
        }

        /// <summary>Releases the other materials; the feature disposes of its own.</summary>
        public void Dispose()
        {
            foreach (Material material in others.Values) CoreUtils.Destroy(material);
            others.Clear();
        }
    }
}
