#pragma once

#include <string>
#include <vector>

#include "measure_plots.h"

namespace lobelia::cli {

/// A picture that was drawn.
struct DrawnPlot {
    MeasurePlot plot;
    std::string svg;
};

/// A web page in one file that shows the pictures, and the means as tables.
std::string measure_page(const MeasureSummary& summary, const std::vector<DrawnPlot>& plots);

} // namespace lobelia::cli
