// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/comparison.h"

namespace plumbline::compare {

/// Whether a name stands for a sequence: it has a run of '#', one for each digit of the frame.
bool is_sequence(const std::string& pattern);

/// The files of one frame.
struct FrameFiles {
    int frame;
    std::filesystem::path reference, test;
};

/// The frames of two sequences, ascending: `ref.####.exr` is ref.0000.exr, ref.0001.exr, ...
/// Numbers with more digits than '#' belong to it too. Throws ImageError if there are none, or a
/// frame of one has no file in the other; UsageError if only one of the names is a sequence or it
/// has two runs.
std::vector<FrameFiles> sequence_frames(const std::string& reference, const std::string& test);

/// What is kept of each frame.
struct FrameError {
    int frame;
    Metrics metrics;
    std::optional<NoiseSplit> noise;
    std::size_t non_finite;
};

/// The frames with their errors, and of each metric the mean over the frames in which it is
/// defined, its largest value and that frame.
nlohmann::ordered_json sequence_json(const std::vector<FrameError>& errors);
/// The same as a table: a line a frame, then mean and largest.
std::string sequence_text(const std::vector<FrameError>& errors);
/// One line a frame; empty where a metric is not defined.
std::string sequence_csv(const std::vector<FrameError>& errors);

}  // namespace plumbline::compare
