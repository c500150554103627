using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Penumbra.Tests
{
    /// <summary>
    /// A pass that is not one of the shader's: it records its steps itself, into textures that are as large as a part of
    /// the shadow map, and others read the last one by name. Nothing but its class knows of it.
    /// </summary>
    public sealed class OwnStepTests
    {
        private sealed class MapReduction : ShadowPass
        {
            private static readonly int Dispatched = Shader.PropertyToID("_Dispatched");
            internal static readonly int Answer = Shader.PropertyToID("_SmallMap");

            internal readonly List<string> Targets = new List<string>();

            internal override int Order => 50;
            internal override bool IsNeeded(in ShadowOptions options) => true;

            internal static ChainTexture Texture(int divisor) =>
                new ChainTexture(ChainExtent.ShadowMap, divisor, GraphicsFormat.B8G8R8A8_UNorm, randomWrite: true);

            internal override void AddSteps(ShadowChain chain, in ShadowOptions options) =>
                chain.Publish(chain.Run(this, 1, Texture(4), chain.Run(this, 0, Texture(2))), Answer);

            internal override void Record(CommandBuffer commands, in ShadowFrame frame, RTHandle target, int run)
            {
                Targets.Add(target.What);
                commands.SetGlobalVector(Dispatched, new Vector4(run, 0.0f, 0.0f, 0.0f));
            }
        }

        private static ShadowFrame Frame(int cascades)
        {
            ShadowFrame frame = default;
            frame.options = ShadowPresets.Options(QualityPreset.Low);
            frame.uniforms = new ShadowUniforms(frame.options.Parameters(), new AtlasLayout(2048, cascades), 0);
            frame.width = 641;
            frame.height = 361;
            frame.widthScale = frame.heightScale = 0.5f;  // of the screen, not of the map
            return frame;
        }

        [Test]
        public void ItsStepsFindTheirTexturesAndSizesAndOthersItsAnswer()
        {
            var reduction = new MapReduction();
            ShadowPass[] passes = ShadowPassList.All.Append(reduction).OrderBy(pass => pass.Order).ToArray();
            var draw = new ChainDraw(new Material(FakeShader.Install()), passes, ChainKeywords.All);
            ShadowFrame frame = Frame(cascades: 2);
            draw.Prepare(frame.options);
            RTHandle[] slots =
                Enumerable.Range(0, draw.Chain.Slots.Count).Select(i => new RTHandle { What = "slot " + i }).ToArray();
            var commands = new CommandBuffer();
            draw.Draw(commands, frame, slots);
            var device = new FakeDevice();
            device.Play(commands);

            string[] targets = draw.Chain.Steps.Select(step => slots[step.target].What).ToArray();
            Assert.That(reduction.Targets, Is.EqualTo(targets.Take(2)));
            Assert.That(device.Uniforms["_Dispatched"], Is.EqualTo(new Vector4(1.0f, 0.0f, 0.0f, 0.0f)));
            FakeDevice.DrawCall resolve = device.Draws.Single();
            Assert.That(resolve.Textures["_SmallMap"], Is.EqualTo(targets[1]));
            Assert.That(resolve.Textures["_PenumbraSourceTexture"], Is.EqualTo(targets[0]));
            // Of two cascades the map is half as high as wide.
            Assert.That((Vector4)resolve.Uniforms["_PenumbraSourceSize"],
                        Is.EqualTo(new Vector4(1024.0f, 512.0f, 1.0f / 1024.0f, 1.0f / 512.0f)));
            Assert.That(((Vector4)resolve.Uniforms["_PenumbraTargetSize"]).x, Is.EqualTo(321.0f));
        }

        [Test]
        public void AMapsTextureIsTheSameForBothEyes()
        {
            RenderTextureDescriptor target = new FakeScene { Views = 2, DynamicResolution = true }.Target();
            target.dimension = TextureDimension.Tex2DArray;
            target.vrUsage = VRTextureUsage.TwoEyes;
            RenderTextureDescriptor ofMap = UrpFrame.Texture(target, MapReduction.Texture(4), Frame(4));
            Assert.That((ofMap.width, ofMap.height, ofMap.volumeDepth), Is.EqualTo((512, 512, 1)));
            Assert.That((ofMap.dimension, ofMap.vrUsage), Is.EqualTo((TextureDimension.Tex2D, VRTextureUsage.None)));
            Assert.That(ofMap.useDynamicScale, Is.False);
            Assert.That(ofMap.enableRandomWrite);
            Assert.That(ofMap.graphicsFormat, Is.EqualTo(GraphicsFormat.B8G8R8A8_UNorm));
            RenderTextureDescriptor ofScreen = UrpFrame.Texture(target, ChainTexture.OfScreen(2), Frame(4));
            Assert.That((ofScreen.width, ofScreen.height, ofScreen.volumeDepth), Is.EqualTo((161, 91, 2)));
            Assert.That((ofScreen.dimension, ofScreen.vrUsage),
                        Is.EqualTo((TextureDimension.Tex2DArray, VRTextureUsage.TwoEyes)));
            Assert.That(ofScreen.useDynamicScale);
            Assert.That(ofScreen.enableRandomWrite, Is.False);
        }
    }
}
