// SPDX-License-Identifier: Apache-2.0
#pragma once

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

/// What a study found.
struct StudyPage {
    std::string title;
    std::string command;            ///< makes the same page
    std::vector<std::string> lead;  ///< paragraphs that say what was found, and how it was measured
    std::vector<StudySection> sections;
};

/// The study as one HTML file that opens offline and asks the network for nothing. All text is
/// escaped. Values that are not finite are left out of charts.
std::string study_html(const StudyPage& page);

}  // namespace plumbline::reports
