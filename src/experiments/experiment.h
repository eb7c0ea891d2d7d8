// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "geometry/util/expected.h"

namespace tactooth {

/// One curve of a plot.
struct PlotSeries {
    std::string name;
    std::vector<std::array<double, 2>> points;  ///< x, y
    bool marked = false;                        ///< a dot at each point
    bool dashed = false;                        ///< for values that are not measured: published, exact, ideal
};

/// One pair of axes.
struct ExperimentPlot {
    std::string title;
    std::string xTitle;  ///< with the unit
    std::string yTitle;  ///< with the unit
    bool logX = false;
    bool logY = false;
    std::vector<PlotSeries> series;
};

/// A published number and ours, as text with units.
struct Comparison {
    std::string what;
    std::string published;
    std::string ours;
};

using Cell = std::variant<std::string, double>;

/// The results of one experiment.
struct Experiment {
    std::string id;  ///< also the name of its files
    std::string title;
    std::string method;  ///< a few sentences
    std::vector<std::string> columns;
    std::vector<std::vector<Cell>> rows;
    int plotColumns = 1;  ///< columns of panels
    std::vector<ExperimentPlot> panels;
    std::vector<Comparison> comparisons;
};

/// Writes the rows as CSV: the names of the columns, then one line a row. A text that holds a comma or a quotation mark
/// is quoted.
[[nodiscard]] Expected<void> writeExperimentCsv(const Experiment& experiment, const std::filesystem::path& path);

/// A measured value with three significant digits and a decimal point, without zeros at the end: "0.0123", "12.3",
/// "1230"; "none" if it is not finite.
[[nodiscard]] std::string shortNumber(double value);

}  // namespace tactooth
