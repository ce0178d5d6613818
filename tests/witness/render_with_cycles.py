# SPDX-License-Identifier: Apache-2.0
"""Run inside Blender: renders a glTF scene of Plumbline with Cycles under Plumbline's conventions.

    blender -b --factory-startup --python-exit-code 1 --python render_with_cycles.py --
        SCENE.gltf WIDTH HEIGHT SPP THREADS SEED [SEED ...] OUT_PREFIX

writes OUT_PREFIX.SEED.exr (linear, 32-bit) for each seed and prints "seconds SEED S" for each. No clamping, box filter of
one pixel, no denoiser, no adaptive sampling, no light threshold, diffuse surfaces only, as many bounces as Cycles allows.
"""
import json
import math
import sys
import time

import bpy
import numpy

numpy.bool = bool  # a name that the importer of Blender 3.4 uses and NumPy 1.24 no longer has


def arguments():
    scene, width, height, spp, threads, *seeds, out = sys.argv[sys.argv.index("--") + 1:]
    return scene, int(width), int(height), int(spp), int(threads), [int(seed) for seed in seeds], out


def import_gltf(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=path)
    return json.load(open(path, encoding="utf-8"))


def shade_flat():
    """Plumbline shades with the normals of the triangles; the importer smooths a mesh that brings normals."""
    for mesh in bpy.data.meshes:
        mesh.use_auto_smooth = False
        mesh.polygons.foreach_set("use_smooth", [False] * len(mesh.polygons))


def plain_lambert(material, albedo, two_sided):
    """A Lambert surface; seen from behind, a one-sided one lets camera rays pass and is black to all others."""
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    lambert = nodes.new("ShaderNodeBsdfDiffuse")
    lambert.inputs["Color"].default_value = (*albedo, 1)
    lambert.inputs["Roughness"].default_value = 0
    output = nodes.new("ShaderNodeOutputMaterial")
    if two_sided:
        links.new(lambert.outputs[0], output.inputs["Surface"])
        return
    black = nodes.new("ShaderNodeBsdfDiffuse")
    black.inputs["Color"].default_value = (0, 0, 0, 1)
    back = nodes.new("ShaderNodeMixShader")
    side = nodes.new("ShaderNodeMixShader")
    links.new(nodes.new("ShaderNodeLightPath").outputs["Is Camera Ray"], back.inputs[0])
    links.new(black.outputs[0], back.inputs[1])
    links.new(nodes.new("ShaderNodeBsdfTransparent").outputs[0], back.inputs[2])
    links.new(nodes.new("ShaderNodeNewGeometry").outputs["Backfacing"], side.inputs[0])
    links.new(lambert.outputs[0], side.inputs[1])
    links.new(back.outputs[0], side.inputs[2])
    links.new(side.outputs[0], output.inputs["Surface"])


def set_materials(gltf):
    described = {material["name"]: material for material in gltf["materials"]}
    for material in bpy.data.materials:
        told = described[material.name]
        albedo = told["pbrMetallicRoughness"].get("baseColorFactor", [1, 1, 1, 1])[:3]
        plain_lambert(material, albedo, told.get("doubleSided", False))


def set_lights(gltf):
    """A point light's power in W is 4 pi times its radiant intensity; without radius its shadows are hard."""
    described = {light["name"]: light for light in gltf["extensions"]["KHR_lights_punctual"]["lights"]}
    for light in bpy.data.lights:
        told = described[light.name]
        if told["type"] != "point":
            raise SystemExit(f"{light.name}: a light of type {told['type']}, where only point lights are compared")
        light.color = told.get("color", [1, 1, 1])
        light.energy = 4 * math.pi * told.get("intensity", 1)
        light.shadow_soft_size = 0
        light.cycles.max_bounces = 1024
        light.cycles.use_multiple_importance_sampling = False


def set_world():
    world = bpy.data.worlds.new("black")
    world.color = (0, 0, 0)
    bpy.context.scene.world = world


def set_cycles(width, height, spp, threads):
    scene = bpy.context.scene
    scene.camera = next(thing for thing in scene.objects if thing.type == "CAMERA")
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = width, height, 100
    scene.render.threads_mode, scene.render.threads = "FIXED", threads
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.image_settings.exr_codec = "ZIP"
    scene.view_settings.view_transform = "Raw"
    scene.render.use_persistent_data = True
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples = spp
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.pixel_filter_type = "BOX"
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.blur_glossy = cycles.light_sampling_threshold = 0
    cycles.max_bounces = cycles.diffuse_bounces = cycles.transparent_max_bounces = 1024


def main():
    path, width, height, spp, threads, seeds, out = arguments()
    gltf = import_gltf(path)
    shade_flat()
    set_materials(gltf)
    set_lights(gltf)
    set_world()
    set_cycles(width, height, spp, threads)
    for seed in seeds:
        bpy.context.scene.cycles.seed = seed
        bpy.context.scene.render.filepath = f"{out}.{seed}.exr"
        begin = time.perf_counter()
        bpy.ops.render.render(write_still=True)
        print(f"seconds {seed} {time.perf_counter() - begin:.3f}", flush=True)


main()
