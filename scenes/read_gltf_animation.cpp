// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenes/nearest_name.h"
#include "scenes/read_gltf.h"
#include "scenes/scene_checks.h"
#include "scenes/unit_rotation.h"

namespace plumbline {
namespace {

constexpr int longest_spline = 1'000'000;
/// From here on floats skip whole frames.
constexpr float last_told_apart = 16'777'216.f;

/// A sampler's keyframes as they are written: `values` has 3 rows a key if `cubic`.
struct Keys {
    JsonView place;
    std::vector<float> frames;
    GltfAccessors::Values values;
    Interpolation interpolation = Interpolation::Linear;
    bool cubic = false;

    /// Row `r` of the values, its missing components zero.
    glm::vec4 row(std::size_t r) const {
        const auto components = static_cast<std::size_t>(values.components);
        glm::vec4 value(0.f);
        for (std::size_t c = 0; c < components; ++c) {
            value[static_cast<int>(c)] = values.numbers[r * components + c];
        }
        return value;
    }
};

/// The same time at another rate; the same bits at the same one.
float frame_at(float frame, float rate, float other_rate) {
    return static_cast<float>(double{frame} * double{other_rate} / double{rate});
}

/// Keyframes in frames; exactly as they were if Plumbline wrote them, since seconds would round.
std::vector<float> frames_of(const JsonView& sampler, GltfBeingRead& gltf) {
    const float own_rate = gltf.scene.frames_per_second;
    std::vector<float> frames = gltf.accessors.floats(sampler.at("input"), {"SCALAR"}).numbers;
    std::vector<float> exact;
    if (const auto extras = plumbline_extras(sampler)) {
        for (const JsonView& frame : extras->at("frames").items()) exact.push_back(frame.real());
    }
    constexpr float rounding = 1e-5f;
    const bool same = std::equal(
        frames.begin(), frames.end(), exact.begin(), exact.end(), [&](float seconds, float frame) {
            return std::abs(seconds * own_rate - frame) <= rounding * (1.f + std::abs(frame));
        });
    if (!same) {
        for (float& time : frames) time *= gltf.rate();
        return frames;
    }
    for (float& frame : exact) frame = frame_at(frame, own_rate, gltf.rate());
    return exact;
}

Keys read_keys(const JsonView& sampler, const char* type, GltfBeingRead& gltf) {
    Keys keys{sampler, frames_of(sampler, gltf),
              gltf.accessors.floats(sampler.at("output"), {type})};
    if (const auto given = sampler.find("interpolation")) {
        const std::string name = given->text();
        const std::string known[] = {"LINEAR", "STEP", "CUBICSPLINE"};
        if (std::find(std::begin(known), std::end(known), name) == std::end(known)) {
            given->fail("there is no interpolation " + in_quotes(name), did_you_mean(name, known));
        }
        if (name == "STEP") keys.interpolation = Interpolation::Step;
        keys.cubic = name == "CUBICSPLINE";
    }
    const std::size_t rows = keys.frames.size() * (keys.cubic ? 3 : 1);
    if (keys.values.count() != rows) {
        sampler.at("output").fail(
            fmt::format("has {} values for {} keyframes", keys.values.count(), keys.frames.size()),
            fmt::format("it needs {}", rows));
    }
    for (std::size_t i = 1; i < keys.frames.size(); ++i) {
        if (keys.frames[i - 1] < keys.frames[i]) continue;
        sampler.at("input").fail(fmt::format("keyframe {} is not later than the one before", i),
                                 "keyframes must rise");
    }
    return keys;
}

/// The spline's value at `t` in [0,1] between keys `i` and `i + 1` [glTF 2.0, appendix C.3].
glm::vec4 spline(const Keys& keys, std::size_t i, float t, float frames_per_second) {
    const float seconds = (keys.frames[i + 1] - keys.frames[i]) / frames_per_second;
    const float t2 = t * t;
    const float t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * keys.row(3 * i + 1) +
           seconds * (t3 - 2 * t2 + t) * keys.row(3 * i + 2) +
           (-2 * t3 + 3 * t2) * keys.row(3 * i + 4) + seconds * (t3 - t2) * keys.row(3 * i + 3);
}

/// A cubic spline as linear keyframes at its ends and at every whole frame between, where it is
/// met exactly.
Track<glm::vec4> sampled(const Keys& keys, float frames_per_second) {
    Track<glm::vec4> track;
    const float first = keys.frames.front();
    const float last = keys.frames.back();
    if (!(last - first <= longest_spline)) {
        keys.place.fail(fmt::format("is a spline over {:g} frames", last - first),
                        fmt::format("the longest has {}", longest_spline));
    }
    if (!(std::max(std::abs(first), std::abs(last)) < last_told_apart)) {
        keys.place.fail(fmt::format("is a spline from frame {:g} to {:g}", first, last),
                        fmt::format("whole frames are told apart up to {}", last_told_apart));
    }
    std::size_t i = 0;
    const auto add = [&](float frame) {
        while (i + 2 < keys.frames.size() && frame >= keys.frames[i + 1]) ++i;
        const float t = (frame - keys.frames[i]) / (keys.frames[i + 1] - keys.frames[i]);
        track.frames.push_back(frame);
        track.values.push_back(spline(keys, i, t, frames_per_second));
    };
    if (keys.frames.size() == 1) return {Interpolation::Linear, {first}, {keys.row(1)}};
    add(first);
    const auto after_first = static_cast<int>(std::floor(first)) + 1;
    const auto end = static_cast<int>(std::ceil(last));
    for (int frame = after_first; frame < end; ++frame) add(static_cast<float>(frame));
    add(last);
    return track;
}

Track<glm::vec4> rows_of(const Keys& keys, float frames_per_second) {
    if (keys.cubic) return sampled(keys, frames_per_second);
    Track<glm::vec4> track{keys.interpolation, keys.frames, {}};
    for (std::size_t i = 0; i < keys.frames.size(); ++i) track.values.push_back(keys.row(i));
    return track;
}

Track<glm::vec3> vectors(const JsonView& sampler, GltfBeingRead& gltf) {
    const auto rows = rows_of(read_keys(sampler, "VEC3", gltf), gltf.rate());
    Track<glm::vec3> track{rows.interpolation, rows.frames, {}};
    for (const glm::vec4& row : rows.values) track.values.emplace_back(row);
    return track;
}

Track<glm::quat> rotations(const JsonView& sampler, GltfBeingRead& gltf) {
    const Keys keys = read_keys(sampler, "VEC4", gltf);
    const auto rows = rows_of(keys, gltf.rate());
    Track<glm::quat> track{rows.interpolation, rows.frames, {}};
    for (const glm::vec4& row : rows.values) {
        const glm::quat written(row.w, row.x, row.y, row.z);
        // A spline through unit quaternions leaves the unit sphere between its keys.
        const auto unit =
            keys.cubic ? std::optional(glm::normalize(written)) : unit_rotation(written);
        if (!unit) {
            sampler.at("output").fail(
                fmt::format("holds a rotation of length {:g}", glm::length(written)),
                "the quaternion of a rotation has length 1");
        }
        track.values.push_back(*unit);
    }
    return track;
}

void read_channel(const JsonView& channel, const std::vector<JsonView>& samplers,
                  GltfBeingRead& gltf) {
    const JsonView target = channel.at("target");
    const auto node = target.find("node");
    if (!node) return gltf.note("animation of something that is no node");
    const auto index = static_cast<std::size_t>(node->index(gltf.nodes.size(), "node"));
    if (!gltf.parents[index]) return;
    if (gltf.node_objects[index] == -1) return gltf.note("animation of a light or a camera");
    const JsonView& sampler =
        samplers[static_cast<std::size_t>(channel.at("sampler").index(samplers.size(), "sampler"))];
    Animation& animation =
        gltf.scene.objects[static_cast<std::size_t>(gltf.node_objects[index])].animation;
    const std::string path = target.at("path").text();
    if (path == "translation") {
        animation.translation = vectors(sampler, gltf);
    } else if (path == "rotation") {
        animation.rotation = rotations(sampler, gltf);
    } else if (path == "scale") {
        animation.scale = vectors(sampler, gltf);
    } else if (path == "weights") {
        gltf.note("animation of morph targets");
    } else {
        const std::string known[] = {"translation", "rotation", "scale", "weights"};
        target.at("path").fail("nothing is called " + in_quotes(path), did_you_mean(path, known));
    }
}

template <typename T>
float last_frame(const Track<T>& track) {
    return track.empty() ? 0.f : track.frames.back();
}

/// As many frames as the animation lasts, for a file that does not say.
int frames_needed(const GltfBeingRead& gltf, const JsonView& animation) {
    float last = 0.f;
    for (const Object& object : gltf.scene.objects) {
        last =
            std::max({last, last_frame(object.animation.translation),
                      last_frame(object.animation.rotation), last_frame(object.animation.scale)});
    }
    last = frame_at(last, gltf.rate(), gltf.scene.frames_per_second);
    if (last < max_frames) return static_cast<int>(std::ceil(last)) + 1;
    animation.fail(fmt::format("lasts {:g} frames", last),
                   fmt::format("the longest has {}", max_frames));
}

}  // namespace

void read_gltf_animation(GltfBeingRead& gltf) {
    const auto animations = gltf.root.items("animations");
    if (animations.empty()) return;
    if (animations.size() > 1) gltf.note("more animations than one; the first is played");
    const JsonView& animation = animations.front();
    const auto samplers = animation.at("samplers").items();
    for (const JsonView& channel : animation.at("channels").items()) {
        read_channel(channel, samplers, gltf);
    }
    if (!gltf.frames_given) gltf.scene.frames = frames_needed(gltf, animation);
}

}  // namespace plumbline
