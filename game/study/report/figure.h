#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "game/study/result.h"

namespace rambla::game::study {

/// A point of a figure.
struct Mark {
    glm::dvec2 at{0.0};
    double x_low = 0.0;  ///< ends of the whisker through the point; equal to its x: none
    double x_high = 0.0;
    std::string label{};     ///< drawn at the point, or in the key under its number; empty: none
    std::size_t number = 0;  ///< counted from 1, stands for the label where labels would cover each other
};

/// Points of one colour and shape.
struct MarkSeries {
    std::string name;
    std::vector<Mark> marks{};
    bool line = false;
};

/// A plot as it is drawn: what a study may give (Plot) and, besides, whiskers and labels.
struct Figure {
    std::string title;
    std::string x_label;
    std::string y_label;
    bool x_log = false;  ///< what is not above zero lies on the axis' lower end, and a note says so
    bool y_log = false;
    bool pareto = false;
    bool higher_is_better = false;  ///< turns the Pareto front over: for decibels
    bool y_from_zero = false;       ///< a linear y axis holds zero, so that equal heights look equal
    std::vector<MarkSeries> series{};
};

[[nodiscard]] Figure to_figure(const Plot& plot);

/// The study's plotted metric against milliseconds, a figure for each scene in which a grade has both: a
/// series for each technique (the grade's name up to its colon), a labelled mark for each grade with its
/// number among the scene's grades, a whisker from the 10 % to the 90 % percentile of the time, and the
/// Pareto front.
[[nodiscard]] std::vector<Figure> error_figures(const StudyResult& result);

/// error_figures() and the study's own plots.
[[nodiscard]] std::vector<Figure> figures_of(const StudyResult& result);

/// True if a point is finite, so that there is something to draw.
[[nodiscard]] bool has_marks(const Figure& figure);

/// True for metrics of which more is better, such as psnr_db.
[[nodiscard]] bool higher_is_better(const std::string& metric);

/// For each point, whether none is better in one direction and not worse in the other. Better is lower, in y
/// higher with `higher_is_better`. A point that is not finite is never on the front.
[[nodiscard]] std::vector<bool> on_pareto_front(const std::vector<glm::dvec2>& points,
                                                bool higher_is_better = false);

}  // namespace rambla::game::study
