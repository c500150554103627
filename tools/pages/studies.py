"""The studies that scripts/publish measures, in this order, and the blocks of their results on pages."""
import json
import os
from pathlib import Path
from typing import NamedTuple

from figures import ROOT

PENUMBRA = "build/release/penumbra"
URP_PACKAGES = os.environ.get("PENUMBRA_URP_PACKAGES", "")  # without it, the published rows of URP stay
GPU = os.environ.get("PENUMBRA_GPU", "")  # without it, the published times of a GPU stay


class Study(NamedTuple):
    name: str  # of `penumbra measure`: the folder below Documentation~/results
    command: str
    is_wanted: bool = True  # False: the published figures stay


STUDIES = []


def run(name, command, is_wanted=True):
    STUDIES.append(Study(name, command, is_wanted))


def measure(name, *options, is_wanted=True):
    run(name, " ".join([PENUMBRA, "measure", *filter(None, options), "--output", f"build/publish/{name}"]), is_wanted)


# Pictures grow until each scene and light has this many pixels in penumbra. All runs use the same pictures, which are
# ray traced once.
PICTURES = ("--size 480x270 --penumbra-pixels 2000 --cascades 4 --reference-samples 256 --seeds 1 --timing-repeats 0"
            " --no-split")
COMMON = PICTURES + " --map-size 2048"
VARIANTS = "--technique-list tests/study/StudyVariants.technique.json"  # besides the library's techniques
LIGHTS = "--light 0.53 --light 2 --light 5"
BUILT_IN = "contact-boxes,poles-and-fence,trees,slabs,colonnade,street,garden"
SCENES = "--scene " + BUILT_IN


def urp_rows():
    """(rows at URP's default bias, the same without a normal bias): much of the error is the bias's, so the headline
    has both."""
    if not URP_PACKAGES:
        return "", ""
    packages = [f"com.unity.render-pipelines.{name}" for name in ("core", "universal", "universal-config")]
    rows = {}
    for ending, setting, title in (("", "", ""), ("-normal-bias-0", ";@normal-bias=0", ", normal bias 0")):
        rows[ending] = " ".join(
            f"--adapter 'urp-{quality}{ending}=tools/measurement/resolve/adapters/UrpSoftShadows.hlsl;_SHADOWS_SOFT;"
            f"_SHADOWS_SOFT_{quality.upper()};@soft-quality={quality}{setting}'"
            f" --title 'urp-{quality}{ending}=URP {quality.capitalize()}{title}'"
            for quality in ("low", "medium", "high"))
    return " ".join(f"--package-root {name}={URP_PACKAGES}/{name}"
                    for name in packages) + " " + rows[""], rows["-normal-bias-0"]


def hdrp_rows():
    """HDRP before 17 has another PCSS, and none of the data that the adapter fills. It moves the receiver, not the
    casters."""
    package = Path(URP_PACKAGES) / "com.unity.render-pipelines.high-definition"
    constants = package / "Runtime/Lighting/Shadow/HDShadowManager.cs.hlsl"
    if not URP_PACKAGES or not constants.exists() or "dirLightPCSSParams0" not in constants.read_text():
        return ""
    adapter = "tools/measurement/resolve/adapters/HdrpPcss.hlsl;@depth-bias=0;@normal-bias=0"
    return (f"--package-root com.unity.render-pipelines.high-definition={package}"
            f" --adapter 'hdrp-pcss={adapter};@light-scale=0.5' --title \"hdrp-pcss=HDRP's own PCSS\""
            f" --adapter 'hdrp-pcss-full-diameter={adapter}' --title \"hdrp-pcss-full-diameter=HDRP's own PCSS, full"
            f" diameter\"")


URP, URP_UNBIASED = urp_rows()
HDRP = hdrp_rows()
KEPT = ([] if URP else [f"urp-{quality}{ending}" for ending in ("", "-normal-bias-0")
                        for quality in ("low", "medium", "high")]) + (
    [] if HDRP else ["hdrp-pcss", "hdrp-pcss-full-diameter"])
EARLIER = f"--earlier Documentation~/results/presets/results.tsv --earlier-rows {','.join(KEPT)}" if KEPT else ""

# The tents and four taps represent URP's qualities, which are the same filters.
NAMES = (
    "hard bilinear four-tap box-3 box-5 box-7 tent-3 tent-5 tent-7 tent-5-plane tent-5-adaptive"
    " pcss-poisson-25 pcss-poisson-32 pcss-poisson-64 pcss-poisson-100 pcss-poisson-128"
    " pcss-angular-24-16 pcss-angular-64-64 pcss-angular-24-16-hdrp"
    " variance-32 variance-16 exponential-32 exponential-16 log-exponential-16 exponential-variance-32"
    " exponential-variance-16"
    " moments-32 moments-16 unreal-smrt-7-8 godot-pcss-8 godot-pcss-8-half-diameter godot-pcss-32"
    " filament-pcss-16-16 filament-pcss-16-16-bulb filament-dpcf-12 filament-dpcf-12-bulb"
    " variance-quarter single-loop-32 single-loop-32-equal-width single-loop-32-wide single-loop-32-minmax"
    " single-loop-32-mips"
    " single-loop-32-planes vssm-sat-32 vssm-mip-16 vssm-mip-32 mssm-sat-32 mssm-mip-16 evsm-mip").split()
TECHNIQUES = " ".join([VARIANTS, *(f"--technique {name}" for name in NAMES)])

QUALITIES = "low medium high ultra reference".split()
PRESETS = "--technique " + ",".join(prefix + quality for prefix in ("preset-", "fallback-") for quality in QUALITIES)

# The variants in a player: of each preset, and of URP's shaders.
run("variants", f"scripts/pages --take receivers '{URP_PACKAGES}'", bool(URP))
run("emit", f"{PENUMBRA} emit")

# The cost of the techniques on three families of AMD GPUs, without the hardware.
run("cost", f"{PENUMBRA} cost --format json --output Documentation~/results/cost.json")
MANIFEST = json.loads((ROOT / "tests" / "study" / "StudyVariants.technique.json").read_text())
MEASURED_VARIANTS = ",".join(entry["name"] for entry in MANIFEST["techniques"] if entry["name"] in NAMES)
run("variants-cost", f"{PENUMBRA} cost {VARIANTS} --technique {MEASURED_VARIANTS} --family navi21 --format json"
    " --output Documentation~/results/variants-cost.json")

# The headline: the presets through the package's own shader, and what URP and HDRP do themselves, each at its own
# recommended settings, on all scenes and models that the program knows.
measure("presets", COMMON, LIGHTS, PRESETS, URP, URP_UNBIASED, HDRP, EARLIER)

# The operations of the presets, from the bytecode of Unity's compiler.
measure("preset-operations", "--front-end fxc --cascades 4 --map-size 2048 --timing-repeats 0 --no-split", LIGHTS,
        SCENES,
        "--size 960x540 --reference-samples 32 --seeds 1", PRESETS, "--technique screen-pcss-angular-24-16")

# The cost and the savings of the masks.
measure("masks", VARIANTS, COMMON, LIGHTS, "--set blockerSamples=12 --set filterSamples=24 --technique screen-pcss-angular-24-16"
        " --technique screen-pcss-angular-24-16-masked --technique screen-pcss-angular-24-16-conservative")

# Every technique, called for surfaces that are known exactly, each at its own recommended settings.
measure("techniques", COMMON, LIGHTS, SCENES, TECHNIQUES)

# All at the same bias: ours, and URP's default.
FEW = "--scene contact-boxes --scene poles-and-fence --scene trees --scene colonnade --light 2"
for name, bias in (("equal-bias", 0), ("equal-bias-urp", 1)):
    measure(name, COMMON, FEW, TECHNIQUES, URP, f"--depth-bias 1 --normal-bias {bias} --soft-quality medium")

# With low float precision: 100 km from the world's origin.
measure("far-origin", COMMON, FEW,
        "--technique bilinear --technique tent-5 --technique pcss-angular-24-16 --origin 100000 0 100000")

# Fits, blends and ages of the cascades, under the sun, where the texels' size decides the error.
for name, map_size, values in (("light-fit", 2048, "sphere,casters,receivers,turned-receivers,turned-receivers-range"),
                               ("cascade-blend", 1024, "none,dither,mix"),
                               ("map-age", 2048, "0,0.01,0.02,0.05,0.1,0.2,0.5")):
    measure(name, PICTURES, f"--map-size {map_size} --light 0.53", SCENES,
            f"--technique tent-5-plane,pcss-angular-24-16 --{name} {values}")

# Beyond the cascades.
FAR = (VARIANTS + " --size 960x540 --cascades 4 --map-size 2048 --light 0.53 --reference-samples 256 --seeds 1 --timing-repeats 0"
       " --no-split")
VALLEYS = "--scene valley-5,valley-20,valley-45"
GROUND = "--technique far-horizon --technique far-heights-8 --technique far-heights-64"
STEPS = "--technique far-heights-64 --set heightSteps=8,16,32,64,128,256"
measure("far-shadows", FAR, VALLEYS, "--technique pcss-angular-24-16", GROUND,
        "--technique pcss-angular-24-16-far-horizon --technique pcss-angular-24-16-far-heights")
for size in (128, 256, 512, 1024):
    measure(f"far-sizes/{size}", FAR, VALLEYS, "--technique far-horizon --technique far-heights-64",
            f"--ground-samples {size} --horizon-texels {size}")
for azimuth in ("0", "11.25", "22.5", "33.75", "45"):
    measure(f"far-azimuths/{azimuth}", FAR, f"--scene valley-5 --sun 5,{azimuth}", GROUND)
measure("far-steps", FAR, VALLEYS, STEPS)
measure("far-steps-azimuth", FAR, "--scene valley-5 --sun 5,33.75", STEPS)
measure("far-clouds", FAR, "--scene valley-20-clouds --technique pcss-angular-24-16-far-horizon"
        " --technique pcss-angular-24-16-far-horizon-clouds --technique screen-high-trace-far-heights-clouds")

# Shadow volumes, beside the shadow map's own hard test and filters.
measure("shadow-volumes", COMMON, "--light 0.53 --light 2 --scene contact-boxes,slabs,trees,street"
        " --technique shadow-volume,hard,bilinear,tent-5-plane,pcss-angular-24-16")

# Planar shadows and blobs, which need no map.
measure("planar-and-blob", "--technique hard,tent-5,pcss-angular-24-16,planar,blob --scene all", LIGHTS,
        "--size 480x270 --reference-samples 256 --seeds 1 --timing-repeats 0 --no-split")

# The share of light along rays.
run("volumetric", "scripts/build penumbra_resolve_tests")
run("volumetric", "env PENUMBRA_VOLUMETRIC_RESULTS=Documentation~/results/volumetric.json"
                  " build/release/penumbra_resolve_tests"
    " --gtest_filter='RayVisibility.*'")

# Whole scenes from distance fields.
measure("distance-field-scenes", VARIANTS, COMMON, LIGHTS, "--scene contact-boxes,slabs,colonnade,street --technique hard"
        " --technique pcss-angular-24-16 --technique distance-field-hard --technique distance-field-cone --technique"
        " distance-field-soft")

# The cost and the error of each screen pass.
measure("screen-passes", VARIANTS, COMMON, "--pan-frames 3 --light 2", SCENES, "--technique pcss-angular-24-16", *(
    f"--technique screen-{name}" for name in (
        "tent-5", "tent-5-masked", "pcss-angular-24-16", "pcss-angular-24-16-masked", "pcss-angular-24-16-conservative",
        "pcss-angular-24-16-denoised", "pcss-angular-24-16-half", "pcss-angular-24-16-half-masked-denoised")))


# Noise that turns disks, and the denoiser.
def measure_noise(name, *options):
    measure(name, "--technique-list tests/study/noise/NoiseStudy.technique.json --timing-repeats 0 --no-split",
            *options)


NOISES = ("gradient", "mask", "gradient-denoised", "mask-denoised")
IN_SMALL = "--scene trees,poles-and-fence,street,colonnade --light 0.53,2,5 --seeds 4 --reference-samples 256"
HIGH, MEDIUM = (",".join(f"pcss-{samples}-{noise}" for noise in NOISES) for samples in ("24-16", "8-16"))
measure_noise("noise", f"--technique {HIGH} --technique {MEDIUM}", IN_SMALL, "--history 1,0.1")
measure_noise("denoise-radius", "--technique pcss-24-16-gradient-denoised --set denoiseRadius=0,1,2,4,8", IN_SMALL)
measure_noise("noise-pan",
              f"--technique {HIGH} --scene trees,street --light 2,5 --seeds 1 --pan-frames 4 --reference-samples 256")
# Shading each sample where a pixel of a multisampled picture sees several surfaces.
measure("edges", PICTURES, "--map-size 2048 --light 0.53 --light 2", SCENES, "--edge-samples 4 --technique tent-5-plane"
        " --technique screen-pcss-angular-24-16 --technique screen-pcss-angular-24-16-edges")

# Contact shadows: alone and after the preset High, after Tent 5x5 at URP's normal bias, and for which lengths and
# thicknesses.
CONTACTS = VARIANTS + " --scene contact-boxes,poles-and-fence,trees,colonnade,street"
measure("contact-shadows", COMMON, LIGHTS, CONTACTS,
        "--technique screen-trace-12,screen-tent-5,preset-high,screen-high-trace")
measure("contact-shadows-urp-bias", COMMON, LIGHTS, CONTACTS,
        "--normal-bias 1 --technique screen-tent-5,screen-tent-5-trace")
measure("contact-shadow-settings", COMMON, "--light 0.53", CONTACTS,
        "--normal-bias 1 --technique screen-tent-5,screen-tent-5-trace"
        " --set screen-tent-5-trace:traceLengthMetres=0.1,0.5,2 --set screen-tent-5-trace:traceThicknessMetres=0.02,"
        "0.05,0.15,0.5"
        " --set screen-tent-5-trace:traceSteps=12,24")

# Techniques of each kind from FXC's bytecode, which Unity runs, beside glslang's modules.
for front_end in ("glslang", "fxc"):
    measure(f"front-ends/{front_end}",
            f"--front-end {front_end} --cascades 4 --map-size 2048 --timing-repeats 0 --no-split --light 2", SCENES,
            "--size 240x135 --reference-samples 64 --seeds 1 --technique hard,tent-3,tent-5,tent-7,pcss-poisson-25,"
            "pcss-angular-24-16,"
            "pcss-angular-24-16-hdrp,godot-pcss-8,filament-pcss-16-16,unreal-smrt-7-8,single-loop-32,variance-32,"
            "exponential-32,"
            "moments-32,vssm-sat-32,mssm-sat-32,evsm-mip,pcss-bounded-16-16,tiled-pcss,tiled-pcss-half")

# How much pictures change from frame to frame.
measure("tiled-pcss-pan",
        "--cascades 4 --map-size 2048 --timing-repeats 0 --no-split --light 0.53,2 --size 480x270 --reference-samples"
        " 64"
        " --seeds 1 --pan-frames 8 --scene street,trees,contact-boxes,colonnade"
        " --technique preset-medium,preset-high,preset-ultra,pcss-bounded-16-16,pcss-angular-64-64,"
        "screen-pcss-angular-24-16")

# The mean over frames, at rest and in motion, beside the same chain without it, with more samples, and PCSS.
FRAMES = ("--front-end fxc --cascades 4 --map-size 2048 --timing-repeats 0 --no-split --light 0.53,2,5 --size 480x270"
          " --reference-samples 128 --seeds 2 --pan-frames 4 --scene street,trees,contact-boxes,colonnade")
measure("accumulation", FRAMES, "--frame-step 1.3 --technique preset-medium,screen-medium-accumulated,preset-high,preset-ultra,"
        "pcss-angular-64-64")
measure("accumulation-at-rest", FRAMES, "--frame-step 0 --technique screen-medium-accumulated")

# How much of a penumbra narrower than a texel the texels' bits tell; soft shadows through distance fields, by the
# penumbra's width, and of several objects.
for program, file in (("penumbra_texel_errors", "texel-edges.json"), ("penumbra_field_errors", "distance-fields.json")):
    run(file.removesuffix(".json"), f"scripts/build {program}")
    run(file.removesuffix(".json"), f"build/release/{program} Documentation~/results/{file}")

# Wires and smoke, which blend: with the opacity mask and without.
measure("wires", VARIANTS, COMMON, LIGHTS, "--scene wires-and-smoke"
        " --technique pcss-angular-24-16,pcss-angular-24-16-opacity,single-loop-32,single-loop-32-opacity")

# One lit view by all techniques, each with at most 32 fetches per pixel, passes over the shadow map included.
VIEW = ("--scene garden --light 2 --size 1280x720 --cascades 4 --reference-samples 256 --seeds 1 --timing-repeats 0"
        " --no-split")
measure("equal-fetches", VARIANTS, VIEW, "--map-size 2048 --technique tent-7-plane,box-5-plane,pcss-angular-24-16"
        " --technique pcss-angular-24-16-hdrp,godot-pcss-8,filament-pcss-16-16,filament-dpcf-12,unreal-smrt-7-8,"
        "single-loop-32"
        " --technique single-loop-32-planes,vssm-mip-32,mssm-sat-32,mssm-mip-16,evsm-mip"
        " --set pcss-angular-24-16-hdrp:blockerSamples=16 --set pcss-angular-24-16-hdrp:filterSamples=16"
        " --set godot-pcss-8:samples=16 --set unreal-smrt-7-8:rays=4")
measure("equal-fetches-small-map", VIEW, "--map-size 1024 --technique pcss-angular-24-16,variance-32,exponential-32"
        " --technique log-exponential-16,exponential-variance-32,moments-32,moments-16,vssm-sat-32")

# Tiled PCSS beside PCSS and a tent, on pictures of which each pixel is one sample; operations are those of FXC's
# bytecode. Nothing was tuned on the kept models, which come with the Debian packages assimp-testmodels and
# glmark2-data.
MAPS = "--cascades 4 --map-size 2048"
TILED_PCSS = f"--front-end fxc {MAPS} --timing-repeats 0 --no-split"
PEERS = ("--technique preset-low,preset-medium,preset-high,preset-ultra,preset-reference,pcss-bounded-16-16,"
         "screen-pcss-angular-24-16,pcss-angular-64-64,tent-7")
ALL_SCENES = SCENES + (",package:glmark2/horse,package:glmark2/bunny,package:glmark2/cat,package:assimp/milk-truck,"
                       "package:assimp/engine")
measure("tiled-pcss", TILED_PCSS, "--flip --light 0.53,2,5 --size 960x540 --reference-samples 256 --seeds 2",
        ALL_SCENES, PEERS)
FEW_PEERS = ("--technique preset-low,preset-medium,preset-high,preset-ultra,screen-pcss-angular-24-16,"
             "pcss-angular-64-64")
measure("tiled-pcss-low-sun", TILED_PCSS, "--light 0.53,2,5,12 --sun 8 40 --size 960x540 --reference-samples 128"
        " --seeds 1", ALL_SCENES, FEW_PEERS)
measure("tiled-pcss-wide-lights", TILED_PCSS, "--light 8,12,20,30 --size 960x540 --reference-samples 128 --seeds 1",
        SCENES, FEW_PEERS)
measure("tiled-pcss-overlaps", TILED_PCSS, "--overlaps --light 0.53,2,5 --size 960x540 --reference-samples 256 --seeds 2",
        "--scene overlaps,garden,trees,street", PEERS + ",unreal-smrt-7-8")
measure("tiled-pcss-full-hd", TILED_PCSS, "--light 0.53,2,5 --size 1920x1080 --reference-samples 64 --seeds 1",
        ALL_SCENES, FEW_PEERS)
measure("tiled-pcss-large-map", "--front-end fxc --cascades 4 --map-size 4096 --timing-repeats 0 --no-split"
        " --light 0.53,2,5 --size 960x540 --reference-samples 128 --seeds 2", SCENES, FEW_PEERS)
measure("tiled-pcss-kept", TILED_PCSS, "--light 0.53,2,5 --size 960x540 --reference-samples 256 --seeds 2 --height 3"
        " --scene /usr/share/assimp/models/OBJ/WusonOBJ.obj,/usr/share/assimp/models/Collada/duck.dae,"
        "/usr/share/assimp/models/STL/Spider_ascii.stl,/usr/share/glmark2/models/asteroid-high.3ds", PEERS)
measure("tiled-pcss-samples", TILED_PCSS, "--light 0.53,2,5 --size 960x540 --reference-samples 256 --seeds 2",
        ALL_SCENES, "--technique screen-pcss-angular-24-16,pcss-angular-64-64,tiled-pcss"
        " --set tiled-pcss:searchSamples=8,16,64 --set tiled-pcss:filterSamples=16,64")

# The operations of what was timed on a GPU and is still there, in the same pictures: times of others follow from them.
measure("gpu-operations", TILED_PCSS, "--light 0.53,2,5 --size 1920x1080 --reference-samples 32 --seeds 1"
        " --scene street,trees,contact-boxes,colonnade --technique tent-7,pcss-angular-24-16-hdrp,pcss-angular-24-16,"
        "pcss-angular-64-64")

# On a GPU, PENUMBRA_GPU=NVIDIA for example; scripts/measure-gpu has six minutes for both. The filters alone, to which the
# predictions are fitted, are in the first.
ON_GPU = f"--device '{GPU}' {MAPS} --no-split --timing-repeats 20 --light 0.53,2,5 --seeds 1 --reference-samples 32"
COMPARED = FEW_PEERS + ",pcss-angular-24-16"
measure("gpu-times/1920x1080", ON_GPU, "--size 1920x1080 --scene street,trees,contact-boxes,colonnade",
        COMPARED + ",pcss-angular-24-16-hdrp,tent-7", is_wanted=bool(GPU))
measure("gpu-times/3840x2160", ON_GPU, "--size 3840x2160 --scene street", COMPARED, is_wanted=bool(GPU))

# The pictures, each by the command below it on its page.
run("pictures", "scripts/pictures")


# One technique of each kind; results.tsv has the others, too.
EQUAL_BIAS = ("hard four-tap tent-5 tent-7 tent-5-plane pcss-poisson-64 pcss-angular-24-16 pcss-angular-24-16-hdrp"
              " variance-32 moments-32 unreal-smrt-7-8 godot-pcss-8 filament-pcss-16-16 filament-dpcf-12 single-loop-32"
              " vssm-mip-32 evsm-mip").split()
FULL = {"presets": "presets.md", "techniques": "filters.md", "tiled-pcss": "tiled-pcss.md"}  # with a chart
BRIEF = {"equal-bias": "filters.md", "equal-bias-urp": "filters.md", "equal-fetches": "filters.md",
         "equal-fetches-small-map": "filters.md",
         "far-origin": "pipelines.md", "planar-and-blob": "other-shadows.md",
         "distance-field-scenes": "other-shadows.md",
         "wires": "other-shadows.md", "tiled-pcss-full-hd": "tiled-pcss.md", "tiled-pcss-low-sun": "tiled-pcss.md",
         "tiled-pcss-wide-lights": "tiled-pcss.md", "tiled-pcss-overlaps": "tiled-pcss.md", "tiled-pcss-kept": "tiled-pcss.md",
         "tiled-pcss-large-map": "tiled-pcss.md"}

# The techniques of a block, where it does not have all of its study: disks of other sizes have the same errors.
ROWS = {"techniques": [name for name in NAMES if name not in {f"pcss-poisson-{samples}" for samples in (32, 100, 128)}],
        "equal-bias": EQUAL_BIAS, "equal-bias-urp": EQUAL_BIAS}
HEADLINE = ("urp-high", "urp-high-normal-bias-0", "hdrp-pcss", "preset-high")
