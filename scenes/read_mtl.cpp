// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <map>

#include "scenes/nearest_name.h"
#include "scenes/printable.h"
#include "scenes/read_obj.h"
#include "scenes/text_lines.h"

namespace plumbline {
namespace {

const std::string matt = ": the surface is taken as matt";
const std::string specular = "specular reflection" + matt;
const std::string transparency = "transparency";

/// Statements without effect on diffuse reflection and emission, or that only shape what another
/// statement asks for: how sharp highlights are, say.
const std::set<std::string_view> shaping_only = {"Ka",        "Ns",     "Ni",     "Tf",
                                                 "sharpness", "Pr",     "Pcr",    "anisor",
                                                 "map_Ka",    "map_Ns", "map_Pr", "map_aat"};

/// Statements that ask for something whatever their values.
const std::map<std::string_view, std::string> not_read = {
    {"map_Kd", "albedo texture"}, {"map_Ke", "emission texture"}, {"map_Ks", specular},
    {"refl", specular},           {"map_d", transparency},        {"map_Tr", transparency},
    {"map_Bump", "normal map"},   {"map_bump", "normal map"},     {"bump", "normal map"},
    {"norm", "normal map"}};

/// Statements that ask for nothing if all their values are zero.
const std::set<std::string_view> none_at_zero = {"Tr", "Ks", "Pm", "Ps", "Pc", "aniso"};

/// True if the statement has one number or more, each of them `value`.
bool all_are(float value, const std::vector<std::string_view>& words) {
    return words.size() > 1 && std::all_of(words.begin() + 1, words.end(), [&](auto word) {
               float number = 0.f;
               const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
               return read.ec == std::errc() && read.ptr == word.data() + word.size() &&
                      number == value;
           });
}

/// What a statement other than newmtl, Kd and Ke asks for that is not read; empty if nothing.
std::string asked_for(const std::vector<std::string_view>& words) {
    const std::string_view kind = words.front();
    if (shaping_only.contains(kind)) return {};
    if (const auto known = not_read.find(kind); known != not_read.end()) return known->second;
    if (kind == "d") return all_are(1.f, words) ? std::string() : transparency;
    if (all_are(0.f, words) && none_at_zero.contains(kind)) return {};
    if (kind == "Tr") return transparency;
    if (kind == "Ks") return specular;
    if (kind == "Pm") return "metallic reflection" + matt;
    if (kind == "illum" && words.size() > 1) {
        // 1 is diffuse reflection, 2 adds the highlights that Ks asks for.
        if (all_are(1.f, words) || all_are(2.f, words)) return {};
        return "illumination model " + printable(words[1]) + matt;
    }
    return "statements " + in_quotes(kind);
}

}  // namespace

std::vector<ObjMaterial> read_mtl(const std::filesystem::path& path) {
    TextLines lines(path);
    std::vector<ObjMaterial> materials;
    while (lines.next()) {
        const std::string_view kind = lines.words().front();
        if (kind == "newmtl") {
            materials.emplace_back().material.name = printable(lines.rest());
        } else if (kind == "Kd" || kind == "Ke") {
            if (materials.empty()) lines.fail("stands before any newmtl", "begin with newmtl NAME");
            const Spectrum value(lines.number(1), lines.number(2), lines.number(3));
            Material& material = materials.back().material;
            (kind == "Kd" ? material.albedo : material.emission) = value;
        } else if (const std::string what = asked_for(lines.words());
                   !what.empty() && !materials.empty()) {
            materials.back().left_out.insert(what);
        }
    }
    return materials;
}

}  // namespace plumbline
