#pragma once

#include <string>
#include <vector>

#include "game/study/report/axis.h"
#include "game/study/report/drawing.h"
#include "game/study/report/figure.h"
#include "game/study/report/label_placement.h"

namespace rambla::game::study {

/// What stands at the marks of a figure.
enum class LabelStyle {
    none,     ///< nothing: the legend names the series
    names,    ///< the labels themselves
    numbers,  ///< numbers, which the legend resolves: the labels would cover each other
};

/// Whether a mark has a place. One that is not finite is left out.
[[nodiscard]] bool is_drawn(const Mark& mark);

/// All values that an axis has to hold, ends of whiskers included; of marks that are drawn.
[[nodiscard]] std::vector<double> x_values(const Figure& figure);
[[nodiscard]] std::vector<double> y_values(const Figure& figure);

/// What a reader of the figure has to know about its points: how many are missing, or lie at an axis' end.
[[nodiscard]] std::vector<std::string> notes_of(const Figure& figure);

/// Draws the Pareto front, lines, whiskers, marks and labels into the frame. @return  how marks are labelled
LabelStyle draw_marks(Drawing& drawing, const Figure& figure, const Axis& x, const Axis& y, const Box& frame);

}  // namespace rambla::game::study
