// SPDX-License-Identifier: Apache-2.0
#include "scenes/read_obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <set>

#include "scenes/errors.h"
#include "scenes/nearest_name.h"
#include "scenes/printable.h"
#include "scenes/text_lines.h"

namespace plumbline {
namespace {

/// Statements whose absence from the picture loses nothing; "vt" places textures, which read_mtl
/// says to be left out.
const std::set<std::string_view> without_effect = {"vt", "o", "g"};

/// An OBJ file while it is read.
struct ObjBeingRead {
    TextLines lines;
    ObjFile file;
    std::map<std::string, int> materials;
    std::set<std::string> left_out;
    int material = -1;

    void read_vertex();
    void read_face();
    void use_material(const std::string& name);
    unsigned vertex_index(std::string_view word) const;
};

void ObjBeingRead::read_vertex() {
    Mesh& mesh = file.mesh;
    mesh.positions.emplace_back(lines.number(1), lines.number(2), lines.number(3));
    const bool coloured = lines.words().size() >= 7;
    if (coloured) {
        mesh.vertex_albedo.resize(mesh.positions.size() - 1, Spectrum(1.f));
        mesh.vertex_albedo.emplace_back(lines.number(4), lines.number(5), lines.number(6));
    } else if (!mesh.vertex_albedo.empty()) {
        mesh.vertex_albedo.emplace_back(1.f);
    }
}

/// "7", "7/1" or "7/1/3": the first counts vertices from 1, or from the last one if negative.
unsigned ObjBeingRead::vertex_index(std::string_view word) const {
    const std::string_view digits = word.substr(0, word.find('/'));
    long long index = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (read.ec != std::errc() || read.ptr != digits.data() + digits.size()) {
        lines.fail(in_quotes(word) + " is no corner of a face", "write 7, 7/1 or 7/1/3");
    }
    const auto count = static_cast<long long>(file.mesh.positions.size());
    const long long zero_based = index < 0 ? count + index : index - 1;
    if (zero_based < 0 || zero_based >= count) {
        lines.fail(fmt::format("asks for vertex {}", index),
                   fmt::format("there are 1 to {} so far", count));
    }
    return static_cast<unsigned>(zero_based);
}

/// The corner from which a fan covers the polygon without turning over, if there is one.
std::optional<std::size_t> fan_corner(const std::vector<unsigned>& corners, const Mesh& mesh) {
    const auto at = [&](std::size_t i) {
        return glm::dvec3(mesh.positions[corners[i % corners.size()]]);
    };
    const auto area = [&](std::size_t a, std::size_t b, std::size_t c) {
        return glm::cross(at(b) - at(a), at(c) - at(a));
    };
    glm::dvec3 normal(0.);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) normal += area(0, i, i + 1);
    for (std::size_t first = 0; first < corners.size(); ++first) {
        bool upright = true;
        for (std::size_t i = 1; upright && i + 1 < corners.size(); ++i) {
            upright = glm::dot(area(first, first + i, first + i + 1), normal) >= 0.;
        }
        if (upright) return first;
    }
    return std::nullopt;
}

void ObjBeingRead::read_face() {
    constexpr std::size_t most_corners = 1000;
    std::vector<unsigned> corners;
    for (std::size_t i = 1; i < lines.words().size(); ++i) {
        corners.push_back(vertex_index(lines.words()[i]));
    }
    if (corners.size() < 3 || corners.size() > most_corners) {
        lines.fail(fmt::format("has {} corners", corners.size()),
                   fmt::format("a face has 3 to {}", most_corners));
    }
    const auto first = fan_corner(corners, file.mesh);
    if (!first) lines.fail("is too concave to be cut to triangles", "triangulate the mesh");
    const auto corner = [&](std::size_t i) { return corners[(*first + i) % corners.size()]; };
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        file.mesh.triangles.emplace_back(corner(0), corner(i), corner(i + 1));
        file.mesh.triangle_materials.push_back(material);
    }
}

void ObjBeingRead::use_material(const std::string& name) {
    const auto [place, is_new] =
        materials.try_emplace(name, static_cast<int>(file.materials.size()));
    if (is_new) file.materials.push_back(name);
    material = place->second;
}

}  // namespace

ObjFile read_obj(const std::filesystem::path& path) {
    ObjBeingRead read{TextLines(path), {}, {}, {}, -1};
    while (read.lines.next()) {
        const std::string_view kind = read.lines.words().front();
        if (kind == "v") {
            read.read_vertex();
        } else if (kind == "f") {
            read.read_face();
        } else if (kind == "usemtl") {
            read.use_material(printable(read.lines.rest()));
        } else if (kind == "mtllib") {
            read.file.libraries.push_back(read.lines.rest());
        } else if (kind == "vn" || kind == "s") {
            read.left_out.insert("vertex normals: triangles are shaded flat");
        } else if (!without_effect.contains(kind)) {
            read.left_out.insert("OBJ statements " + in_quotes(kind));
        }
    }
    if (read.file.mesh.triangles.empty()) {
        throw SceneError(path.string(), "has no faces", "it may not be a Wavefront OBJ file");
    }
    read.file.left_out.assign(read.left_out.begin(), read.left_out.end());
    return std::move(read.file);
}

}  // namespace plumbline
