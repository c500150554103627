using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Rendering;

namespace Penumbra
{
    /// <summary>A chain with its programs, or with the reason why it cannot run.</summary>
    internal sealed class PreparedChain
    {
        private readonly ShadowOptions options;

        /// <summary>
        /// The reason why this chain stands in for the one that was asked for, as a message; null if it does not.
        /// </summary>
        internal readonly string replaces;

        internal readonly ShadowChain chain;
        internal readonly ProgramAsset[] assets;

        /// <summary>The programs in the order of the chain's steps.</summary>
        internal readonly PassProgram[] programs;

        /// <summary>
        /// The preallocated array of a step's targets, for steps that draw into several; null for others.
        /// </summary>
        internal readonly RenderTargetIdentifier[][] targets;

        /// <summary>The message that says what is missing; null if nothing is.</summary>
        internal readonly string problem;

        /// <param name="options">Options, of which those that choose a chain count.</param>
        /// <param name="bothEyes">Whether the chain draws both eyes at once.</param>
        /// <param name="overLit">See ChainDraw.Prepare.</param>
        internal PreparedChain(in ShadowOptions options, bool bothEyes, bool overLit, PassMaterials materials,
                               string replaces = null)
        {
            this.options = options;
            this.replaces = replaces;
            chain = overLit ? ShadowChain.OverLit(options) : ShadowChain.Of(options);
            programs = new PassProgram[chain.Steps.Count];
            targets = new RenderTargetIdentifier[chain.Steps.Count][];
            problem = (overLit ? null : DeviceLimits.Problem(options)) ?? DeviceLimits.Problem(chain) ??
                      (bothEyes ? DeviceLimits.StereoProblem(chain) : null);
            IReadOnlyList<string> known = ChainKeywords.All;
            IReadOnlyList<string> on = bothEyes ? chain.Keywords.Append(ChainKeywords.BothEyes).ToArray() : chain.Keywords;
            var used = new Dictionary<string, ProgramAsset>();
            for (int i = 0; i < programs.Length && problem == null; ++i)
            {
                GraphPass pass = chain.Steps[i].pass;
                if (pass.kind == PassKind.Lit) continue;
                if (!used.TryGetValue(pass.asset, out ProgramAsset asset))
                {
                    problem = materials.Find(pass, out Object found, out Material material);
                    if (problem != null) break;
                    asset = used[pass.asset] = new ProgramAsset(found, material, known, on);
                }
                problem = Find(pass, asset, out programs[i]) ??
                          (bothEyes ? DeviceLimits.StereoProblem(chain, chain.Steps[i], asset) : null);
                if (problem == null && pass.kind == PassKind.Casters) problem = asset.CasterProblem(pass);
                if (pass.kind == PassKind.Raster && pass.writes.Length > 1 ||
                    pass.kind == PassKind.Casters && pass.writes.Length > 0)
                    targets[i] = new RenderTargetIdentifier[pass.writes.Length];
            }
            assets = new ProgramAsset[used.Count];
            used.Values.CopyTo(assets, 0);
        }

        /// <summary>`asked` with the choices of this chain.</summary>
        internal ShadowOptions Of(in ShadowOptions asked)
        {
            ShadowOptions drawn = asked;
            drawn.technique = options.technique;
            drawn.mapFormat = options.mapFormat;
            drawn.conservativeMask = options.conservativeMask;
            drawn.clouds = options.clouds;
            drawn.accumulates = options.accumulates;
            return drawn;
        }

        private static string Find(GraphPass pass, ProgramAsset asset, out PassProgram program)
        {
            program = default;
            if (pass.kind != PassKind.Compute)
            {
                program = new PassProgram(asset, asset.material.FindPass(pass.program));
                return program.index >= 0 ? null : pass.asset + " has no pass '" + pass.program + "'";
            }
            if (!asset.kernels.HasKernel(pass.program))
                return pass.asset + " has no kernel '" + pass.program + "', or it does not compile";
            int kernel = asset.kernels.FindKernel(pass.program);
            if (!asset.kernels.IsSupported(kernel))
                return "this device cannot run kernel '" + pass.program + "' of " + pass.asset;
            asset.kernels.GetKernelThreadGroupSizes(kernel, out uint x, out uint y, out uint z);
            program = new PassProgram(asset, kernel, new Vector3Int((int)x, (int)y, (int)z));
            return DeviceLimits.Problem(pass, program.threads);
        }
    }
}
