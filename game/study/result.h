#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

#include "assets/image.h"

namespace rambla::game::study {

/// A number that says how good a grade's result is.
struct Metric {
    std::string name;  ///< with its unit at the end: "flip_mean", "angle_p99_deg"
    double value = 0.0;
    std::string unit;  ///< "", "%", "deg", "mm", "dB"
};

/// What one grade of a technique cost in one scene, and how far its result was from the reference.
struct GradeResult {
    std::string scene;  ///< with all that makes it another: "blocks, 64 lights, 1280x720"
    std::string grade;  ///< as the command line takes it: "clustered:tile=64"
    /// Milliseconds, one value per round; in a round all grades of a scene do the same work. Empty: not
    /// timed.
    std::vector<double> ms{};
    double bytes = 0.0;  ///< that the grade keeps for its work
    std::vector<Metric> metrics{};
};

/// Points of one colour in a plot.
struct Series {
    std::string name;
    std::vector<glm::dvec2> points;
    bool line = false;  ///< joined in the order of the points
};

struct Plot {
    std::string title;
    std::string x_label;  ///< with its unit
    std::string y_label;
    bool x_log = false;  ///< what is not above zero then lies on the axis' lower end
    bool y_log = false;
    bool pareto = false;  ///< draws the front of the points that none is both left of and below
    std::vector<Series> series;
};

/// A table that is more than grades and their metrics.
struct Table {
    std::string title;
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;  ///< as long as the head; the first column names the row
};

struct LabelledPicture {
    std::string label;    ///< such as the grade's name
    assets::Image image;  ///< rgba8
};

/// Pictures of one size that are looked at side by side, such as before and after.
struct PictureRow {
    std::string title;
    std::vector<LabelledPicture> pictures;
};

/// All that a study found.
struct StudyResult {
    std::string name;       ///< as the command line takes it
    std::string title;      ///< "Lighting paths"
    std::string question;   ///< what it asks, a sentence or two
    std::string reference;  ///< what errors are measured against, and why that is right
    std::string command;    ///< that runs it again
    std::vector<GradeResult> grades{};
    std::string plotted_metric{};  ///< drawn against milliseconds, a plot for each scene; empty: none
    std::vector<Plot> plots{};     ///< further ones
    std::vector<Table> tables{};
    std::vector<PictureRow> pictures{};
    std::string incomplete{};  ///< why something is missing; empty: nothing is
    double duration_s = 0.0;
};

/// What results depend on besides the code, as pairs of name and value: machine, driver, date, seed.
using RunFacts = std::vector<std::pair<std::string, std::string>>;

}  // namespace rambla::game::study
