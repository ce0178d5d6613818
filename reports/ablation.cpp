// SPDX-License-Identifier: Apache-2.0
#include "reports/ablation.h"

#include <cmath>

#include "ddgi/picture.h"
#include "ddgi/stopwatch.h"
#include "ddgi/volume.h"
#include "reports/allocated.h"
#include "reports/layer_statistics.h"
#include "scenes/errors.h"
#include "scenes/progress.h"

namespace plumbline::reports {

namespace {

const std::string layer = "indirect";

/// The gain g that makes the sum of (g t - r)^2 least: sum t r / sum t^2, or 1 without light.
double best_gain(const compare::LayerPair& pair) {
    double product = 0;
    double square = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < pair.pixels(); ++i) {
            if (pair.usable[i] == 0) continue;
            product += double(pair.test[c][i]) * double(pair.reference[c][i]);
            square += double(pair.test[c][i]) * double(pair.test[c][i]);
        }
    }
    return square > 0 ? product / square : 1;
}

double rmse_with(double gain, const compare::LayerPair& pair) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < pair.pixels(); ++i) {
            if (pair.usable[i] == 0) continue;
            const double d = gain * double(pair.test[c][i]) - double(pair.reference[c][i]);
            sum += d * d;
        }
    }
    return std::sqrt(sum / (3. * static_cast<double>(pair.usable_pixels)));
}

AblationRow measure_case(const Scene& scene, int frame, const Image& truth,
                         const AblationCase& subject) {
    const std::size_t before = allocated_bytes();
    ddgi::ProbeVolume volume(scene, subject.ddgi);
    volume.move_to(frame);
    AblationRow row{};
    row.subject = subject;
    row.place_ms = volume.figures().place_ms;
    row.light_ms = volume.figures().light_ms;
    row.surfels_hit = volume.figures().surfels_hit;
    row.surfels_lit = volume.figures().surfels_lit;
    row.shadow_rays = volume.figures().surfel_shadow_rays;
    volume.converge();
    row.bytes = static_cast<double>(allocated_bytes()) - static_cast<double>(before);
    row.updates = volume.figures().updates;
    row.converged = volume.figures().converged;
    row.update_ms = (volume.figures().light_ms - row.light_ms) / row.updates;
    const ddgi::Stopwatch watch;
    const ddgi::Picture picture =
        ddgi::take_picture(volume.tracer(), volume.model(), &volume,
                           ddgi::picture_options(subject.ddgi, volume.model()));
    row.primary_ms = watch.ms();
    const compare::LayerPair pair = compare::pair_layers(truth, picture.image, layer);
    const auto noise = compare::split_noise(truth, picture.image, pair);
    if (!noise)
        throw ImageError(truth.source, "the truth has no variances of its indirect layer",
                         "render it with `plumbline render`");
    row.noise = *noise;
    row.metrics = compare::pixel_metrics(pair);
    row.non_finite = pair.non_finite;
    row.mean_ratio = layer_mean(picture.image, layer) / layer_mean(truth, layer);
    row.best_gain = best_gain(pair);
    row.rmse_with_gain = rmse_with(row.best_gain, pair);
    return row;
}

}  // namespace

AblationScene measure_ablation(const Scene& scene, int frame, const Image& truth,
                               const std::vector<AblationCase>& cases) {
    AblationScene result{scene.name, frame, truth.width(), truth.height(), {}};
    Progress progress("Ablation of " + scene.name, cases.size());
    for (const AblationCase& subject : cases) {
        result.rows.push_back(measure_case(scene, frame, truth, subject));
        progress.advance();
    }
    return result;
}

}  // namespace plumbline::reports
