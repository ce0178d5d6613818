// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "compare/fit.h"
#include "reports/study_section.h"

namespace plumbline::reports {

/// The thesis's constants fitted on each scene, tested on every one and at other frames.
struct Transfer {
    int width, height, truth_spp;
    std::vector<compare::TransferError> errors;
};

/// A scene whose constants are fitted, at the frame at which they are.
struct TransferScene {
    const Scene* scene;
    int frame;
};

/// Fits on the given scenes and on two of the library that are unlike the thesis's, two-rooms and
/// courtyard, each at a picture of at most `pixels`; tests on all of these, and on frame 0 of those
/// of them that move and are fitted at another. Throws FitError.
Transfer measure_transfer(const std::vector<TransferScene>& scenes, double pixels, int truth_spp);

/// What the table shows, in a sentence.
std::string transfer_sentence(const Transfer& transfer);

/// A row for each scene that was fitted, a column for each that was tested.
StudyTable transfer_table(const Transfer& transfer);

StudySection transfer_section(const Transfer& transfer);

}  // namespace plumbline::reports
