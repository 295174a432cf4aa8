#pragma once

#include <string>
#include <vector>

#include "measure_summary.h"

namespace lobelia::cli {

/// A picture as a script for gnuplot.
struct MeasurePlot {
    std::string name;    // of its files, without ending
    std::string caption; // what it shows
    std::string script;  // all but the terminal
};

/// The pictures that there are measurements for.
std::vector<MeasurePlot> measure_plots(const MeasureSummary& summary);

} // namespace lobelia::cli
