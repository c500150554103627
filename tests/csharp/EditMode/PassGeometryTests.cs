using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace Penumbra.Tests
{
    public sealed class PassGeometryTests
    {
        private static ShadowFrame Frame(int cascades, int width = 1921, int height = 1081, float scale = 1.0f)
        {
            ShadowFrame frame = default;
            frame.layout = new AtlasLayout(2048, cascades);
            frame.width = width;
            frame.height = height;
            frame.widthScale = frame.heightScale = scale;
            return frame;
        }

        private static ChainTexture Texture(GraphExtent extent, int divisor = 1, int mips = 1, int layers = 1,
                                            int width = 0, int height = 0, int depth = 1) =>
            new ChainTexture(new GraphTexture("t", extent, GraphicsFormat.R8_UNorm, divisor, width, height, depth, mips,
                                              layers), false, false);

        private static (int, int, int) Size(in ChainTexture texture, in ShadowFrame frame, int mip = 0)
        {
            TextureSize size = TextureSize.Of(texture, frame).At(mip);
            return (size.width, size.height, size.depth);
        }

        [TestCase(1, 1921, 1921)]
        [TestCase(2, 1921, 961)]
        [TestCase(4, 1921, 481)]
        [TestCase(4, 2, 1)]
        public void SizesRoundUp(int divisor, int screen, int size) =>
            Assert.That(TextureSize.Of(ChainTexture.OfScreen(divisor), Frame(4, screen, screen)).width,
                        Is.EqualTo(size));

        [Test]
        public void EveryExtentHasItsSize()
        {
            Assert.That(Size(Texture(GraphExtent.Screen, 2, layers: 3), Frame(4)), Is.EqualTo((961, 541, 3)));
            Assert.That(Size(Texture(GraphExtent.Map, 4), Frame(2)), Is.EqualTo((512, 256, 1)));
            Assert.That(Size(Texture(GraphExtent.Tile, 4), Frame(3)), Is.EqualTo((256, 256, 3)));
            ChainTexture volume = Texture(GraphExtent.Fixed, width: 32, height: 16, depth: 8);
            Assert.That(Size(volume, Frame(4)), Is.EqualTo((32, 16, 8)));
            Assert.That(Size(volume, Frame(4), 3), Is.EqualTo((4, 2, 1)));
            ChainTexture layered = Texture(GraphExtent.Fixed, width: 32, height: 16, layers: 8);
            Assert.That(Size(layered, Frame(4), 3), Is.EqualTo((4, 2, 8)), "layers have no levels");
        }

        [Test]
        public void DynamicResolutionIsTheScreensAlone()
        {
            ShadowFrame frame = Frame(4, scale: 0.5f);
            Assert.That(TextureSize.Drawn(ChainTexture.OfScreen(1), frame).width, Is.EqualTo(961));
            Assert.That(TextureSize.Drawn(Texture(GraphExtent.Map), frame).width, Is.EqualTo(2048));
            Assert.That(TextureSize.Of(ChainTexture.OfScreen(1), frame).width, Is.EqualTo(1921));
        }

        [Test]
        public void ACopyOfALevelIsAsLargeAsThat()
        {
            ChainTexture whole = Texture(GraphExtent.Screen, mips: 0);
            Assert.That(Size(whole.CopyOf(3), Frame(4)), Is.EqualTo(Size(whole, Frame(4), 3)));
            Assert.That(whole.CopyOf(3).Equals(whole.CopyOf(2)), Is.False);
            Assert.That(whole.CopyOf(3).IsOwned, Is.False);
        }

        [TestCase(GraphExtent.Map, 0, 4, true, 11)]   // levels of tiles of 1024 texels, none smaller than one
        [TestCase(GraphExtent.Map, 0, 4, false, 12)]
        [TestCase(GraphExtent.Map, 0, 1, true, 12)]
        [TestCase(GraphExtent.Map, 3, 4, true, 3)]
        [TestCase(GraphExtent.Tile, 0, 4, true, 11)]
        [TestCase(GraphExtent.Screen, 0, 4, false, 11)]
        [TestCase(GraphExtent.Screen, 15, 4, false, 11)]
        public void LevelsEndAtATexel(object extent, int mips, int cascades, bool byCascade, int levels) =>
            Assert.That(PassGeometry.Levels(Texture((GraphExtent)extent, mips: mips), Frame(cascades), byCascade),
                        Is.EqualTo(levels));

        [Test]
        public void ACascadesAreaIsItsTile()
        {
            ChainTexture map = Texture(GraphExtent.Map, 2, mips: 3);
            Assert.That(PassGeometry.Area(map, Frame(4), true, 3, 1), Is.EqualTo(new Rect(256.0f, 256.0f, 256.0f, 256.0f)));
            Assert.That(PassGeometry.Area(map, Frame(2), true, 1, 0), Is.EqualTo(new Rect(512.0f, 0.0f, 512.0f, 512.0f)));
            Assert.That(PassGeometry.Area(map, Frame(4), false, 3, 1), Is.EqualTo(new Rect(0.0f, 0.0f, 512.0f, 512.0f)));
            Assert.That(PassGeometry.Area(Texture(GraphExtent.Tile), Frame(4), true, 3, 0),
                        Is.EqualTo(new Rect(0.0f, 0.0f, 1024.0f, 1024.0f)));
        }

        [Test]
        public void EachTexelHasAThread()
        {
            var threads = new Vector3Int(8, 4, 2);
            Assert.That(PassGeometry.Groups(Texture(GraphExtent.Screen, 2), Frame(4), false, 1, threads),
                        Is.EqualTo(new Vector3Int(121, 136, 1)));
            Assert.That(PassGeometry.Groups(Texture(GraphExtent.Map), Frame(4), true, 1, threads),
                        Is.EqualTo(new Vector3Int(128, 256, 1)), "of one tile");
            Assert.That(PassGeometry.Groups(Texture(GraphExtent.Map), Frame(4), true, 4, threads),
                        Is.EqualTo(new Vector3Int(32, 64, 1)), "one of 4 x 4 texels");
            Assert.That(PassGeometry.Groups(Texture(GraphExtent.Tile), Frame(4), false, 1, threads),
                        Is.EqualTo(new Vector3Int(128, 256, 2)), "of all tiles");
            Assert.That(PassGeometry.Groups(Texture(GraphExtent.Tile), Frame(4), true, 1, threads),
                        Is.EqualTo(new Vector3Int(128, 256, 1)));
            Assert.That(PassGeometry.Groups(Texture(GraphExtent.Fixed, width: 32, height: 32, depth: 32), Frame(4),
                                            false, 1, threads), Is.EqualTo(new Vector3Int(4, 8, 16)));
        }
    }
}
