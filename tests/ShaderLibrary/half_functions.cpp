#include "ShaderLibrary/half_functions.h"

#include <algorithm>
#include <cmath>

namespace penumbra::shader_library_tests {
namespace {

constexpr Quantity kVisibility{"of visibility", 1.0 / 255.0};    // a step of an 8-bit target
constexpr Quantity kDisc{"of the disc's radius", 1.0 / 64.0};    // less than a texel of a kernel 64 wide
constexpr Quantity kTurn{"of a turn", 1.0 / 64.0, true};         // a rotation by so much is not seen
constexpr Quantity kTexels{"texels", 1.0 / 16.0};                // sixteenth of a texel of the shadow map
constexpr Quantity kDepth{"of the depth range", 1.0 / 65535.0};  // a step of a 16-bit map
constexpr Quantity kMetres{"metres", 0.01};                      // about a texel of the nearest cascade
constexpr Quantity kRings{"rings", 1.0 / 4.0};                   // quarter of one of 32 rings

// A tile of 2048 texels in an atlas of 4096, for a cascade 5 to 200 m wide and 50 to 500 m deep, under a
// light of 0.53 to 5 degrees: uvPerMetre, depthPerMetre, depthToRadial, radialToDepth.
Case tile(Random& random) {
  const float uv_per_metre = 1.0F / random.between(5.0F, 200.0F);
  const float depth_per_metre = 1.0F / random.between(50.0F, 500.0F);
  const float to_radial =
      std::tan(0.00872665F * random.between(0.53F, 5.0F)) * uv_per_metre / depth_per_metre;
  return {uv_per_metre, depth_per_metre, to_radial, 1.0F / to_radial};
}

constexpr const char* kTile =
    "ShadowTile tile; tile.offsetScale = float4(0.5, 0, 0.5, 0.5); tile.atlasTexelSize = float4(1.0 / "
    "4096.0, 1.0 / 4096.0, 4096, 4096); tile.uvPerMetre = In(0); tile.depthPerMetre = In(1); "
    "tile.depthToRadial = In(2); tile.radialToDepth = In(3);";

std::string with_scales(const std::string& statement) {
  return std::string(kTile) + "const ConeScales scales = ConeScalesOf(tile);" + statement;
}

struct Range {
  float low, high;
  bool whole = false;
};

Range whole(int low, int high) {
  return {float(low), float(high), true};
}

// Cases of a number of each range.
Inputs in(std::vector<Range> ranges) {
  return [ranges = std::move(ranges)](Random& random) {
    Case values;
    for (const Range& range : ranges)
      values.push_back(range.whole ? float(random.integer(int(range.low), int(range.high)))
                                   : random.between(range.low, range.high));
    return values;
  };
}

// The numbers that the second makes follow those of the first, and are drawn before them.
Inputs joined(Inputs first, Inputs second) {
  return [first = std::move(first), second = std::move(second)](Random& random) {
    const Case last = second(random);
    Case values = first(random);
    values.insert(values.end(), last.begin(), last.end());
    return values;
  };
}

Inputs on_tile(std::vector<Range> ranges) {
  return joined(tile, in(std::move(ranges)));
}

// The moments of two depths in [-1, 1], then a depth near the farther one or behind it.
Inputs two_depths(int moments) {
  return [moments](Random& random) {
    const float a = random.between(-1.0F, 1.0F), b = random.between(-1.0F, 1.0F),
                share = random.between(0.0F, 1.0F);
    Case values;
    for (int power = 1; power <= moments; ++power)
      values.push_back(share * std::pow(a, float(power)) + (1.0F - share) * std::pow(b, float(power)));
    values.push_back(std::min(1.0F, std::max(a, b) + random.between(-0.05F, 0.2F)));
    return values;
  };
}

// A sample of up to 64.
Case sample(Random& random) {
  const int count = random.integer(1, 64);
  return {float(random.integer(0, count - 1)), float(count)};
}

Case clumped_sample(Random& random) {
  const Case one = sample(random);
  return {one[0], one[1], random.between(0.0F, 2.0F)};
}

// The centre within its texel, as half has it, and the number of fetches.
Case tent(Random& random) {
  return {float(random.integer(0, 1023)) / 1024.0F, float(random.integer(2, 4))};
}

// A unit vector.
Case direction(Random& random) {
  const float z = random.between(-1.0F, 1.0F), angle = random.between(0.0F, 6.2831853F);
  const float across = std::sqrt(1.0F - z * z);
  return {across * std::cos(angle), across * std::sin(angle), z};
}

Case turned_point(Random& random) {
  const float angle = random.between(0.0F, 6.2831853F);
  return {random.between(-0.7F, 0.7F), random.between(-0.7F, 0.7F), std::cos(angle), std::sin(angle)};
}

// A sum and the weight, or the count, that it is divided by.
Case weighted_sum(Random& random) {
  const float weights = random.between(0.25F, 64.0F);
  return {weights * random.between(0.0F, 1.0F), weights};
}

Case counted_sum(Random& random) {
  const int count = random.integer(1, 64);
  return {random.between(0.0F, float(count)), float(count)};
}

// A position in the first sphere and the second, whose border is a step of the weight, and the spheres'
// scale.
Case in_spheres(Random& random) {
  Case position = direction(random);
  const float radius = random.between(0.0F, 1.0F);
  for (float& coordinate : position) coordinate *= radius;
  return {position[0], position[1], position[2] + 0.6F, random.between(3.0F, 50.0F)};
}

const Inputs kUnit = in({{0, 1}});

HalfFunction half(std::string name, const Quantity& quantity, std::string file, std::string statement,
                  int outputs, Inputs inputs, std::string folder = "Core") {
  Random any(1);
  const int words = int(inputs(any).size());
  return {std::move(name),
          quantity,
          {std::move(file), std::move(statement), words, outputs, {}, std::move(folder)},
          std::move(inputs)};
}

}  // namespace

std::vector<HalfFunction> half_functions() {
  return {
      half("FibonacciDisk", kDisc, "Disk", "Out2(0, FibonacciDisk(InInt(0), InInt(1), In(2)));", 2,
           clumped_sample),
      half("VogelDisk", kDisc, "Disk", "Out2(0, VogelDisk(InInt(0), InInt(1)));", 2, sample),
      half("RotateDisk", kDisc, "Disk", "Out2(0, RotateDisk(In2(0), In2(2)));", 2, turned_point),
      half("GradientNoise", kTurn, "Noise", "Out(0, GradientNoise(In2(0), uint(InInt(2))));", 1,
           in({whole(0, 1919), whole(0, 1079), whole(0, 63)})),
      half("RotationFromNoise", kDisc, "Noise", "Out2(0, RotationFromNoise(In(0)));", 2, kUnit),
      half("TentFetches, weights", kVisibility, "TentWeights",
           "const TentAxis axis = TentFetches(In(0), InInt(1)); for (int i = 0; i < 4; ++i) Out(uint(i), "
           "axis.weight[i]);",
           4, tent),
      half("TentFetches, positions", kTexels, "TentWeights",
           "const TentAxis axis = TentFetches(In(0), InInt(1)); for (int i = 0; i < 4; ++i) Out(uint(i), "
           "axis.position[i]);",
           4, tent),
      half("DepthGap", kDepth, "DepthConvention", "Out(0, DepthGap(In(0), In(1)));", 1, in({{0, 1}, {0, 1}})),
      half("TexelCoordinates", kTexels, "TileBounds",
           std::string(kTile) + "Out2(0, TexelCoordinates(In2(4), tile));", 2,
           on_tile({{0.5F, 1}, {0, 0.5F}})),
      half("PenumbraRadius", kTexels, "Penumbra", with_scales("Out(0, PenumbraRadius(In(4), scales));"), 1,
           on_tile({{0, 0.1F}})),
      half("SearchRadius", kTexels, "Penumbra",
           with_scales("Out(0, SearchRadius(In(4), In(5), In(6), scales));"), 1,
           on_tile({{0, 1}, {0.1F, 5}, {0, 2}})),
      half("ConeOffset", kDepth, "Penumbra", with_scales("Out(0, ConeOffset(In(4), In(5), 1.0, scales));"), 1,
           on_tile({{0, 32}, {0, 2}})),
      half("AverageGap", kDepth, "Penumbra", "Out(0, AverageGap(In(0), In(1)));", 1, weighted_sum),
      half("LitShare", kVisibility, "Penumbra", "Out(0, LitShare(In(0), In(1)));", 1, in({{0, 64}, {0, 64}})),
      half("MeanVisibility", kVisibility, "Penumbra", "Out(0, MeanVisibility(In(0), In(1)));", 1,
           counted_sum),
      half("SanitizeVisibility", kVisibility, "FloatBits", "Out(0, SanitizeVisibility(In(0)));", 1,
           in({{-0.5F, 1.5F}})),
      half("ChebyshevBound", kVisibility, "MomentBounds", "Out(0, ChebyshevBound(In2(0), In(2), 1e-5));", 1,
           two_depths(2)),
      half("ReduceBleeding", kVisibility, "MomentBounds", "Out(0, ReduceBleeding(In(0), In(1)));", 1,
           in({{0, 1}, {0, 0.6F}})),
      half("HamburgerBound", kVisibility, "HamburgerBound", "Out(0, HamburgerBound(In4(0), In(4), 3e-5));", 1,
           two_depths(4)),
      half("BlockersOfVariance, share", kVisibility, "BlockerMean",
           "Out(0, BlockersOfVariance(In2(0), In(2), 1e-5).share);", 1, two_depths(2)),
      half("BlockersOfMoments, share", kVisibility, "BlockerMean",
           "Out(0, BlockersOfMoments(In4(0), In(4), 3e-5).share);", 1, two_depths(4)),
      half("RingTapRadius", kDisc, "RingMask", "Out(0, RingTapRadius(InInt(0), 32, InInt(1)));", 1,
           in({whole(0, 31), whole(1, 2)})),
      half("RingsInside", kRings, "RingMask", "Out(0, RingsInside(In(0), 32, InInt(1)));", 1,
           in({{0, 1}, whole(1, 2)})),
      half("RingVisibility", kVisibility, "RingMask",
           "RingMask mask = EmptyRingMask(); mask.words[0] = uint(InInt(0)) | uint(InInt(1)) << 8 | "
           "uint(InInt(2)) << 16 | uint(InInt(3)) << 24; Out(0, RingVisibility(mask, In(4), InInt(5)));",
           1, in({whole(0, 255), whole(0, 255), whole(0, 255), whole(0, 255), {1, 32}, whole(1, 2)})),
      half("NextCascadeWeight", kVisibility, "CascadeSelection",
           "CascadeSpheres spheres; spheres.centre0 = float3(0, 0, 0.6 * In(3)); spheres.centre1 = float3(0, "
           "0, 1.2 * In(3)); spheres.centre2 = spheres.centre1; spheres.centre3 = spheres.centre1; "
           "spheres.squaredRadii = float4(1, 4, 4, 4) * In(3) * In(3); Out(0, NextCascadeWeight(In3(0) * "
           "In(3), spheres, 0, 4, 0.2));",
           1, in_spheres),
      half("ReceiverPlaneDepth", kDepth, "ReceiverPlane",
           "Out(0, ReceiverPlaneDepth(In(0), In2(1), In2(3)));", 1,
           in({{0.1F, 0.9F}, {-4, 4}, {-4, 4}, {-0.004F, 0.004F}, {-0.004F, 0.004F}})),
      half("AdaptiveBias", kDepth, "ShadowBias", "Out(0, AdaptiveBias(In2(0), float2(In(2), In(2)), 0.1));",
           1, in({{-4, 4}, {-4, 4}, {0, 0.004F}})),
      half("CasterBiasMetres", kMetres, "ShadowBias", "Out2(0, CasterBiasMetres(In2(0), In(2), In(3)));", 2,
           in({{0, 3}, {0, 3}, {0.002F, 0.1F}, {1, 3.5F}})),
      half("BiasCaster", kMetres, "ShadowBias",
           "Out3(0, BiasCaster(In3(0), In3(3), float3(0, 1, 0), float2(-0.05, -0.05)));", 3,
           joined(in({{-100, 100}, {0, 20}, {-100, 100}}), direction)),
      half("PlaneWeight", kVisibility, "ScreenPosition", "Out(0, PlaneWeight(In3(0), In3(3), 0.05));", 1,
           joined(in({{-0.1F, 0.1F}, {-0.1F, 0.1F}, {-0.1F, 0.1F}}), direction)),
      half("AxialDepth", kMetres, "SpotLight",
           "Out(0, AxialDepth(In(0), BoundedSpotMap(float4(0.1, 20, 0.6, 0.1))));", 1, kUnit),
      half("PenumbraRadiusMetres", kMetres, "SpotLight",
           "const SpotMap map = BoundedSpotMap(float4(0.1, 20, 0.6, 0.1)); Out(0, "
           "PenumbraRadiusMetres(In(0), In(1), map));",
           1, in({{0, 0.1F}, {1, 20}})),
      half("WarpedMoments, first", kVisibility, "DepthWarp",
           "const float4 m = WarpedMoments(In(0), float2(5.0, 5.0)); Out(0, m.x * exp(-2.5)); Out(1, m.y * "
           "exp(-2.5));",
           2, kUnit, "Map"),
      half("WarpedMoments, second", kVisibility, "DepthWarp",
           "const float4 m = WarpedMoments(In(0), float2(5.0, 5.0)); Out(0, m.z * exp(-5.0)); Out(1, m.w * "
           "exp(-5.0));",
           2, kUnit, "Map"),
      half("MapBlurWeight", kVisibility, "MapBlur", "Out(0, MapBlurWeight(InInt(0), In(1)));", 1,
           in({whole(-8, 8), {0.5F, 4}}), "Map"),
  };
}

}  // namespace penumbra::shader_library_tests
