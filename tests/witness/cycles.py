#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""An independent witness: compares Plumbline's path tracer with Blender's Cycles, and times both to equal error.

    tests/witness/cycles.py [--plumbline build/release/plumbline] [--spp 256] [--threads 2] [--size 256x256] [--json]

Scenes with inverse-square lights are exported to glTF and rendered by both. Means over each object and channel must
agree within their noise: Plumbline's is known from its variance layer, that of Cycles from independent seeds. Exit 0 when they
do, 1 when they don't, 77 (skipped) with the reason when Blender or Python's OpenImageIO is missing.
"""
import argparse
import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

SEEDS = [1, 2, 3, 4]
OFFSET = 0.01  # of relMSE: d^2 / (ref^2 + OFFSET)


def skip(why):
    print(f"skipped: {why}")
    sys.exit(77)


try:
    import numpy
    import OpenImageIO as oiio
except ImportError as missing:
    skip(f"Python has no {missing.name} (Debian: python3-openimageio, python3-numpy)")


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{command[0]} ended with {done.returncode}:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout


def channels(path, names):
    """The named channels of an EXR, float64, height x width x len(names)."""
    image = oiio.ImageInput.open(str(path))
    held = image.spec().channelnames
    pixels = numpy.asarray(image.read_image("float"), dtype=numpy.float64)
    image.close()
    return pixels[..., [held.index(name) for name in names]]


def physical(plumbline, scene, folder):
    """The scene as JSON with inverse-square lights: one without falloff keeps its irradiance 200 units away."""
    path = folder / f"{scene}.json"
    run(plumbline, "export", scene, "-o", path)
    described = json.loads(path.read_text())
    for light in described["lights"]:
        if light["falloff"] == "none":
            light["falloff"] = "inverse_square"
            light["intensity"] = [math.pi * value * 200**2 for value in light.pop("white_radiance")]
    path.write_text(json.dumps(described))
    return path


def as_triangles(plumbline, scene, folder):
    """The scene as glTF; what its extras say of exact shapes is taken out, so that both render the same triangles."""
    path = folder / "triangles.gltf"
    run(plumbline, "export", scene, "-o", path)
    described = json.loads(path.read_text())
    for mesh in described["meshes"]:
        mesh.pop("extras", None)
    path.write_text(json.dumps(described))
    return path


def render_with_plumbline(options, scene, folder):
    out = folder / "plumbline.exr"
    told = json.loads(run(options.plumbline, "render", scene, "-o", out, "--spp", options.spp, "--size", options.size,
                          "--threads", options.threads, "--json", "--quiet"))
    return out, told["seconds"]


def render_with_cycles(options, scene, folder):
    script = pathlib.Path(__file__).with_name("render_with_cycles.py")
    said = run("blender", "-b", "--factory-startup", "--python-exit-code", 1, "--python", script, "--", scene,
               *options.size.split("x"), options.spp, options.threads, *SEEDS, folder / "cycles")
    seconds = [float(line.split()[2]) for line in said.splitlines() if line.startswith("seconds ")]
    return [folder / f"cycles.{seed}.exr" for seed in SEEDS], min(seconds)


def judge(options, name, scene, folder):
    triangles = as_triangles(options.plumbline, scene, folder)
    ours, our_seconds = render_with_plumbline(options, triangles, folder)
    theirs, their_seconds = render_with_cycles(options, triangles, folder)
    radiance = channels(ours, "RGB")
    variance = channels(ours, [f"variance.{c}" for c in "RGB"])
    objects = channels(ours, ["object.Y"])[..., 0]
    witnesses = numpy.stack([channels(path, "RGB") for path in theirs])
    witness = witnesses.mean(axis=0)
    rows = []
    names = [thing["name"] for thing in json.loads(scene.read_text())["objects"]]
    for number in numpy.unique(objects[objects >= 0]).astype(int):
        seen = objects == number
        per_seed = witnesses[:, seen].mean(axis=1)
        for index, channel in enumerate("RGB"):
            own = variance[seen, index].sum() / seen.sum() ** 2
            other = per_seed[:, index].var(ddof=1) / len(SEEDS)
            ours_mean, their_mean = radiance[seen, index].mean(), witness[seen, index].mean()
            # Three degrees of freedom make the variance among seeds itself uncertain: the error that neighbouring
            # pixels' shared sequences leave is bounded from below by the pixels' own spread.
            pixels_own = witnesses[:, seen, index].var(axis=0, ddof=1).sum() / seen.sum() ** 2 / len(SEEDS)
            deviation = (own + max(other, pixels_own)) ** 0.5
            difference = ours_mean - their_mean
            rows.append({"object": names[number], "channel": channel, "pixels": int(seen.sum()),
                         "plumbline": ours_mean, "cycles": their_mean, "difference": difference,
                         "z": difference / deviation if deviation > 0 else 0.0,
                         "agrees": abs(difference) <= 5 * deviation + 1e-6 * abs(their_mean)})
    both = (radiance + witness) / 2
    weight = 1 / (both**2 + OFFSET)
    our_error = (variance * weight).mean()
    their_error = (witnesses.var(axis=0, ddof=1) * weight).mean()
    return {"scene": name, "spp": options.spp, "threads": options.threads, "size": options.size, "objects": rows,
            "plumbline": {"seconds": our_seconds, "relmse": our_error},
            "cycles": {"seconds": their_seconds, "relmse": their_error},
            "time_to_equal_error": our_seconds * our_error / (their_seconds * their_error)}


def show(result):
    print(f"{result['scene']}, {result['size']}, {result['spp']} samples a pixel, {result['threads']} threads")
    print(f"{'object':>24} {'channel':>8} {'pixels':>8} {'Plumbline':>11} {'Cycles':>11} {'ratio':>9} {'z':>7}")
    for row in result["objects"]:
        ratio = row["plumbline"] / row["cycles"] if row["cycles"] else 1.0
        print(f"{row['object']:>24} {row['channel']:>8} {row['pixels']:8d} {row['plumbline']:11.6f} {row['cycles']:11.6f} "
              f"{ratio:9.5f} {row['z']:7.2f}{'' if row['agrees'] else '  disagrees'}")
    for who in ("plumbline", "cycles"):
        print(f"{who:>10}: {result[who]['seconds']:.2f} s to relMSE {result[who]['relmse']:.3g}")
    print(f"time to equal error: {result['time_to_equal_error']:.3f} of Cycles' time\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plumbline", default="build/release/plumbline", type=pathlib.Path)
    parser.add_argument("--spp", default=256, type=int)
    parser.add_argument("--threads", default=2, type=int)
    parser.add_argument("--size", default="256x256")
    parser.add_argument("--json", action="store_true")
    parser.add_argument("scenes", nargs="*", default=["cornell-box", "two-rooms", "integrating-sphere"])
    options = parser.parse_args()
    if shutil.which("blender") is None:
        skip("Blender is not installed (Debian: blender)")
    if not options.plumbline.is_file():
        sys.exit(f"{options.plumbline}: no such program; build it with ./run or name it with --plumbline")
    results = []
    for name in options.scenes:
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            results.append(judge(options, name, physical(options.plumbline, name, folder), folder))
        if not options.json:
            show(results[-1])
    if options.json:
        print(json.dumps(results, indent=2))
    sys.exit(0 if all(row["agrees"] for result in results for row in result["objects"]) else 1)


if __name__ == "__main__":
    main()
