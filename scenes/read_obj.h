// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace plumbline {

/// A Wavefront OBJ file: one mesh, and what it says of materials.
struct ObjFile {
    Mesh mesh;  ///< triangle_materials index `materials`; -1 where no usemtl came before
    std::vector<std::string> materials;  ///< names, in the order of their first use
    std::vector<std::string> libraries;  ///< .mtl files, relative to the OBJ
    std::vector<std::string> left_out;   ///< what it asks for that is not read
};

/// Reads vertices (with colours, if they have some) and faces. Polygons are cut to triangles.
/// Throws SceneError with the line number.
///
/// Own code rather than tinyobjloader, which reads a broken number as zero and knows no lines.
ObjFile read_obj(const std::filesystem::path& path);

/// A material of a .mtl file.
struct ObjMaterial {
    Material material;
    std::set<std::string> left_out;  ///< what it asks for that is not read
};

/// The materials of a .mtl file: Kd is the albedo, Ke the emission. Throws SceneError.
std::vector<ObjMaterial> read_mtl(const std::filesystem::path& path);

}  // namespace plumbline
