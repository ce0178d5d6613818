// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace plumbline::reports {

/// A line of a chart, or the bars of one colour.
struct StudySeries {
    std::string label;
    std::string color;      ///< a custom property of style.css, without dashes in front: series-0
    std::vector<double> x;  ///< as long as y; empty for bars
    std::vector<double> y;
    bool dashed = false;
    bool dots = false;                 ///< shows each point
    bool line = true;                  ///< joins the points
    std::vector<std::string> names{};  ///< of the points, for the pointer; as long as y, or empty
};

/// A chart with numbers along both axes, or, with `labels`, one group of bars a label.
struct StudyChart {
    std::string caption;
    std::string x_title;
    std::string y_title;
    std::vector<StudySeries> series;
    std::vector<std::string> labels;
    std::vector<double> marks;  ///< where dashed vertical lines stand
    bool log_x = false;
    bool log_y = false;
};

struct StudyTable {
    std::string caption;
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;  ///< the first cell names its row
};

struct StudyPicture {
    std::string uri;  ///< data:image/png
    std::string caption;
};

struct StudySection {
    std::string heading;
    std::vector<std::string> paragraphs;
    std::vector<StudyTable> tables;
    std::vector<StudyChart> charts;
    std::vector<StudyPicture> pictures;
};

/// What reports/page/section.html shows of a section under a heading of this level ("h2"). Its
/// charts are appended to `charts`, which study.js reads as report.charts.
nlohmann::json section_context(const StudySection& section, const std::string& level,
                               nlohmann::json& charts);

}  // namespace plumbline::reports
