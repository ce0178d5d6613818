// SPDX-License-Identifier: Apache-2.0
#include "reports/transfer.h"

#include <fmt/core.h>

#include <algorithm>
#include <deque>

#include "compare/transfer.h"
#include "pathtracer/render.h"
#include "reports/animation.h"
#include "reports/picture_size.h"
#include "reports/words.h"
#include "scenes/progress.h"
#include "scenes/scene_files.h"

namespace plumbline::reports {

namespace {

/// A scene with the truth of one frame.
struct Subject {
    Scene scene;
    int frame;
    Image truth;

    compare::FitCase fit_case() const { return {&scene, frame, &truth}; }
};

Subject subject_of(const Scene& scene, int frame, double pixels, int truth_spp) {
    Scene small = scene;
    set_default_size(small.camera, {}, pixels);
    pathtracer::RenderOptions render;
    render.spp = truth_spp;
    Image truth = pathtracer::render(small, frame, render).image;
    return {std::move(small), frame, std::move(truth)};
}

std::string name_of(const std::string& scene, int frame) {
    return fmt::format("{}, frame {}", scene, frame);
}

std::string fitted_name(const compare::TransferError& error) {
    return name_of(error.fitted_on, error.fitted_frame);
}

std::string tested_name(const compare::TransferError& error) {
    return name_of(error.tested_on, error.tested_frame);
}

/// The error that constants fitted there leave; none where none were.
std::optional<double> own_error(const Transfer& transfer, const std::string& tested) {
    for (const compare::TransferError& error : transfer.errors)
        if (fitted_name(error) == tested && tested_name(error) == tested) return error.rmse;
    return std::nullopt;
}

}  // namespace

Transfer measure_transfer(const std::vector<TransferScene>& scenes, double pixels, int truth_spp) {
    std::deque<Subject> fitted, tested;
    const auto has = [&](const std::string& name) {
        return std::ranges::any_of(fitted, [&](const Subject& s) { return s.scene.name == name; });
    };
    for (const TransferScene& one : scenes)
        fitted.push_back(subject_of(*one.scene, one.frame, pixels, truth_spp));
    for (const char* name : {"two-rooms", "courtyard"}) {
        const Scene scene = load_scene(name);
        if (!has(name)) fitted.push_back(subject_of(scene, scene.report_frame, pixels, truth_spp));
    }
    for (const Subject& subject : fitted)
        if (subject.frame != 0 && moving_frames(subject.scene))
            tested.push_back(subject_of(subject.scene, 0, pixels, truth_spp));
    std::vector<compare::FitCase> cases;
    compare::FitSettings settings;
    for (const Subject& subject : fitted) cases.push_back(subject.fit_case());
    for (const Subject& subject : tested) settings.tests.push_back(subject.fit_case());
    const Image& truth = fitted.front().truth;
    return {truth.width(), truth.height(), truth_spp, compare::transfer_errors(cases, settings)};
}

std::string transfer_sentence(const Transfer& transfer) {
    double most = 1;
    const compare::TransferError* worst = nullptr;
    for (const compare::TransferError& error : transfer.errors) {
        const std::optional<double> own = own_error(transfer, tested_name(error));
        if (!own || error.rmse / *own <= most) continue;
        most = error.rmse / *own;
        worst = &error;
    }
    if (worst == nullptr) return "No constants lose by being carried to another scene.";
    return fmt::format(
        "Carried to another scene, constants leave up to {} times the error of those fitted there "
        "({} to {}).",
        number_text(most), fitted_name(*worst), tested_name(*worst));
}

StudyTable transfer_table(const Transfer& transfer) {
    StudyTable table{
        "RMSE of the indirect layer, and in brackets its multiple of the error that "
        "the constants fitted there leave",
        {"Fitted on"},
        {}};
    const std::string first = fitted_name(transfer.errors.front());
    for (const compare::TransferError& error : transfer.errors) {
        if (fitted_name(error) == first) table.head.push_back("on " + tested_name(error));
        if (table.rows.empty() || table.rows.back().front() != fitted_name(error))
            table.rows.push_back({fitted_name(error)});
        const std::optional<double> own = own_error(transfer, tested_name(error));
        table.rows.back().push_back(own ? fmt::format("{} ({} \u00d7)", number_text(error.rmse),
                                                      number_text(error.rmse / *own))
                                        : number_text(error.rmse));
    }
    return table;
}

StudySection transfer_section(const Transfer& transfer) {
    return {"Do the constants belong to the method or to the scene?",
            {transfer_sentence(transfer),
             fmt::format("The thesis's three constants, fitted on each scene alone and tested on "
                         "all, at {} x {} against truths of {} samples a pixel. Constants of the "
                         "method would leave alike errors in each column. All but "
                         "bounceAttenuation are areas, and go over in proportion to the square of "
                         "the spacing.",
                         transfer.width, transfer.height, transfer.truth_spp)},
            {transfer_table(transfer)},
            {},
            {}};
}

}  // namespace plumbline::reports
