// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <glm/trigonometric.hpp>

#include "scenes/input_files.h"
#include "scenes/nearest_name.h"
#include "scenes/read_json.h"
#include "scenes/scene_checks.h"

namespace plumbline {
namespace {

template <typename T, typename ReadValue>
Track<T> read_track(const JsonView& item, const ReadValue& read_value) {
    item.expect_keys({"interpolation", "frames", "values"});
    Track<T> track;
    if (const auto interpolation = item.find("interpolation")) {
        const std::string name = interpolation->text();
        const std::string known[] = {"linear", "step"};
        if (name != known[0] && name != known[1]) {
            interpolation->fail("there is no interpolation " + in_quotes(name),
                                did_you_mean(name, known));
        }
        track.interpolation = name == "step" ? Interpolation::Step : Interpolation::Linear;
    }
    const JsonView frames = item.at("frames");
    for (const JsonView& frame : frames.items()) track.frames.push_back(frame.real());
    if (track.empty()) frames.fail("is empty", "leave the whole property out, or give keyframes");
    for (const JsonView& value : item.at("values").items()) {
        track.values.push_back(read_value(value));
    }
    return track;
}

Wrap read_wrap(const JsonView& item) {
    static const std::map<std::string, int> wraps{
        {"repeat", int(Wrap::Repeat)}, {"mirror", int(Wrap::Mirror)}, {"clamp", int(Wrap::Clamp)}};
    return static_cast<Wrap>(find_name(item, wraps, "wrap"));
}

/// One radiance all around, or a picture.
void read_environment(const JsonView& item, const std::filesystem::path& folder, Scene& scene) {
    if (!item.is_object()) {
        scene.environment = item.vec3_or_number();
        return;
    }
    item.expect_keys({"image", "radiance", "rotation"});
    const JsonView image = item.at("image");
    const std::filesystem::path file = file_inside(folder, image.text(), image);
    scene.environment_image = EnvironmentImage{std::make_shared<Panorama>(read_panorama(file))};
    const auto radiance = item.find("radiance");
    scene.environment = radiance ? radiance->vec3_or_number() : Spectrum(1.f);
    if (const auto degrees = item.find("rotation")) {
        scene.environment_image->rotation = static_cast<float>(glm::radians(degrees->number()));
    }
}

}  // namespace

Texture read_texture(const JsonView& item, const std::filesystem::path& folder) {
    if (item.is_object()) item.expect_keys({"image", "wrap"});
    const JsonView image = item.is_object() ? item.at("image") : item;
    Texture texture{read_picture(file_inside(folder, image.text(), image))};
    if (const auto wrap = item.is_object() ? item.find("wrap") : std::nullopt) {
        texture.wrap_u = texture.wrap_v = read_wrap(*wrap);
    }
    return texture;
}

Transform read_transform(const JsonView& object) {
    Transform transform;
    if (const auto scale = object.find("scale")) transform.scale = scale->vec3_or_number();
    if (const auto rotation = object.find("rotation")) transform.rotation = rotation->rotation();
    if (const auto translation = object.find("translation")) {
        transform.translation = translation->vec3();
    }
    return transform;
}

Animation read_animation(const JsonView& item) {
    item.expect_keys({"translation", "rotation", "scale"});
    Animation animation;
    if (const auto track = item.find("translation")) {
        animation.translation =
            read_track<glm::vec3>(*track, [](const JsonView& value) { return value.vec3(); });
    }
    if (const auto track = item.find("rotation")) {
        animation.rotation =
            read_track<glm::quat>(*track, [](const JsonView& value) { return value.rotation(); });
    }
    if (const auto track = item.find("scale")) {
        animation.scale = read_track<glm::vec3>(
            *track, [](const JsonView& value) { return value.vec3_or_number(); });
    }
    return animation;
}

Camera read_camera(const JsonView& item) {
    item.expect_keys({"eye", "target", "up", "vertical_fov", "width", "height"});
    Camera camera;
    camera.eye = item.at("eye").vec3();
    camera.target = item.at("target").vec3();
    if (const auto up = item.find("up")) camera.up = up->vec3();
    if (const auto fov = item.find("vertical_fov")) {
        camera.vertical_fov = static_cast<float>(glm::radians(fov->number()));
    }
    if (const auto width = item.find("width")) camera.width = width->integer(1, max_image_side);
    if (const auto height = item.find("height")) camera.height = height->integer(1, max_image_side);
    return camera;
}

ProbeGrid read_probes(const JsonView& item) {
    item.expect_keys({"origin", "spacing", "counts"});
    return {item.at("origin").vec3(), item.at("spacing").real(),
            item.at("counts").ivec3(1, max_probes)};
}

ThesisConstants read_thesis(const JsonView& item) {
    item.expect_keys({"falloffRegulator", "bounceAttenuation", "probeBrightness",
                      "multiBounceIntensity", "ambient", "imageBrightness"});
    ThesisConstants thesis;
    thesis.falloffRegulator = item.at("falloffRegulator").real();
    thesis.bounceAttenuation = item.at("bounceAttenuation").real();
    thesis.probeBrightness = item.at("probeBrightness").real();
    thesis.multiBounceIntensity = item.at("multiBounceIntensity").real();
    thesis.ambient = item.at("ambient").real();
    if (const auto brightness = item.find("imageBrightness")) {
        thesis.imageBrightness = brightness->real();
    }
    return thesis;
}

void read_settings(const JsonView& item, const std::filesystem::path& folder, Scene& scene) {
    if (const auto text = item.find("description")) scene.description = text->text();
    if (const auto units = item.find("units")) scene.length_unit = units->text();
    if (const auto environment = item.find("environment")) {
        read_environment(*environment, folder, scene);
    }
    if (const auto frames = item.find("frames")) scene.frames = frames->integer(1, max_frames);
    if (const auto frame = item.find("report_frame")) {
        scene.report_frame = frame->integer(0, max_frames - 1);
    }
    if (const auto rate = item.find("frames_per_second")) {
        scene.frames_per_second = rate->real();
        // Told here, since keyframes are read by it before the scene is checked.
        if (!(scene.frames_per_second > 0.f)) {
            rate->fail(fmt::format("is {:g}", scene.frames_per_second), "it is above 0");
        }
    }
    if (const auto probes = item.find("probes")) scene.probes = read_probes(*probes);
    if (const auto thesis = item.find("thesis")) scene.thesis = read_thesis(*thesis);
}

}  // namespace plumbline
