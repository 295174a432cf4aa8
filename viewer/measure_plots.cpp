#include "measure_plots.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

namespace lobelia::cli {

namespace {

// Okabe and Ito's colours, told apart by all eyes.
constexpr const char* COLOURS[] = {"#D55E00", "#0072B2", "#009E73", "#CC79A7",
                                   "#E69F00", "#56B4E9", "#7F7F00", "#000000"};
constexpr const char* FAINT = "#909090";

constexpr const char* ERROR_AXIS = "relative error (pointwise RMS)";

std::string number(double value) {
    char text[32];
    const auto [end, error] =
        std::to_chars(std::begin(text), std::end(text), value, std::chars_format::scientific, 6);
    return {std::begin(text), end};
}

// In double quotes gnuplot gives meaning to these.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char character : text) {
        if (character == '"' || character == '\\') result += '\\';
        result += character == '\n' ? std::string("\\n") : std::string(1, character);
    }
    return result + "\"";
}

/// Names the methods' colours in the order in which they come up.
class Palette {
public:
    std::string operator()(const std::string& method) {
        auto known = std::find(methods_.begin(), methods_.end(), method);
        if (known == methods_.end()) known = methods_.insert(known, method);
        return quoted(COLOURS[std::size_t(known - methods_.begin()) % std::size(COLOURS)]);
    }

private:
    std::vector<std::string> methods_;
};

/// What pictures have in common.
std::string frame(const MeasureSummary& summary, const std::string& title, const std::string& x,
                  const std::string& y) {
    return "set encoding utf8\n"
           "set termoption noenhanced\n"
           "set logscale xy\n"
           "set format x \"%g\"\nset format y \"%g\"\n"
           "set grid xtics ytics back linetype 1 linecolor rgb \"#E4E4E4\"\n"
           "set border 3 linecolor rgb \"#606060\"\n"
           "set tics nomirror\n"
           "set rmargin 6\n"
           "set key below center horizontal samplen 2 height 1\n"
           "set title " +
           quoted(title + "\n" + summary.device()) + "\nset xlabel " + quoted(x) + " offset 0,0.5" +
           "\nset ylabel " + quoted(y) + "\n";
}

/// Data in the script itself, under a name.
class Blocks {
public:
    std::string add(const std::string& lines) {
        const std::string name = "$block" + std::to_string(count_++);
        text_ += name + " << EOD\n" + lines + "EOD\n";
        return name;
    }
    const std::string& text() const { return text_; }

private:
    std::string text_;
    int count_ = 0;
};

std::string joined(const std::vector<std::string>& curves) {
    std::string text;
    for (const std::string& curve : curves)
        text += (text.empty() ? "plot " : ", \\\n     ") + curve;
    return text + "\n";
}

/// A line through the picture at a time, with its name along it.
std::string mark(double ms, const std::string& label) {
    return "set arrow from " + number(ms) + ", graph 0 to " + number(ms) +
           ", graph 1 nohead dashtype 3 linecolor rgb " + quoted(FAINT) + "\nset label " +
           quoted(label) + " at " + number(ms) +
           ", graph 0.03 left rotate by 90 offset 0.8,0 textcolor rgb " + quoted(FAINT) + "\n";
}

// What tells a point from others of its method.
std::string short_label(const MeasureWay& way) {
    if (way.quality) return *way.quality;
    return way.samples ? std::to_string(*way.samples) : way.method;
}

/// Whether the points of a method lie so close that their labels would cover one another and those
/// of methods beside it.
bool is_crowded(const std::vector<MeasureMean>& means) {
    const auto [fastest, slowest] =
        std::minmax_element(means.begin(), means.end(),
                            [](const auto& one, const auto& other) { return one.ms < other.ms; });
    return means.size() > 1 && slowest->ms < 1.5 * fastest->ms;
}

std::string errors_by_time(const MeasureSummary& summary, const std::vector<MeasureMean>& means,
                           const std::string& title, const std::string& work) {
    Blocks blocks;
    Palette palette;
    std::vector<std::string> curves, methods;
    std::string marks;
    double fastest = INFINITY, slowest = 0.0;
    for (const MeasureMean& mean : means) {
        fastest = std::min(fastest, mean.ms);
        slowest = std::max(slowest, mean.ms);
        if (!mean.rms)
            marks += mark(mean.ms, label_of(mean.way));
        else if (std::find(methods.begin(), methods.end(), mean.way.method) == methods.end())
            methods.push_back(mean.way.method);
    }
    if (const auto yardstick = summary.yardstick()) {
        marks += mark(*yardstick, "mip chain");
        fastest = std::min(fastest, *yardstick);
    }
    std::string front;
    for (const MeasureMean& mean : pareto_front(means))
        front += number(mean.ms) + " " + number(*mean.rms) + "\n";
    curves.push_back(blocks.add(front) + " using 1:2 with steps linewidth 6 linecolor rgb "
                                         "\"#DDDDDD\" title \"Pareto front\"");
    for (const std::string& method : methods) {
        const auto is_of_method = [&](const MeasureMean& mean) {
            return mean.rms && mean.way.method == method;
        };
        std::vector<MeasureMean> of_method;
        std::copy_if(means.begin(), means.end(), std::back_inserter(of_method), is_of_method);
        const bool alone = of_method.size() == 1, crowded = is_crowded(of_method);
        std::string points;
        for (const MeasureMean& mean : of_method)
            points += number(mean.ms) + " " + number(*mean.rms) + " " +
                      quoted(crowded ? ""
                             : alone ? method
                                     : short_label(mean.way)) +
                      "\n";
        const std::string block = blocks.add(points), colour = palette(method);
        curves.push_back(block +
                         " using 1:2 with linespoints linewidth 2 pointtype 7 linecolor "
                         "rgb " +
                         colour + " title " +
                         quoted(crowded ? method + ", " + short_label(of_method.front().way) +
                                              " to " + short_label(of_method.back().way)
                                        : method));
        curves.push_back(block + " using 1:2:3 with labels left offset 0.8,0.3 textcolor rgb " +
                         colour + " notitle");
    }
    return frame(summary, title, work + ", ms (" + summary.clock() + ")", ERROR_AXIS) +
           "set xrange [" + number(fastest / 2) + ":" + number(slowest * 3) + "]\n" + marks +
           blocks.text() + joined(curves);
}

// Of a method's numbers of samples, the least and the most say enough.
std::vector<MeasureLine> told_apart(const std::vector<MeasureLine>& lines) {
    std::vector<MeasureLine> kept;
    for (const MeasureLine& line : lines) {
        const auto less_and_more = [&](const MeasureLine& other, int sign) {
            return other.way.method == line.way.method &&
                   sign * (std::int64_t(*other.way.samples) - *line.way.samples) > 0;
        };
        const auto any = [&](int sign) {
            return std::any_of(lines.begin(), lines.end(), [&](const MeasureLine& other) {
                return other.way.samples && less_and_more(other, sign);
            });
        };
        if (!line.way.samples || !any(-1) || !any(1)) kept.push_back(line);
    }
    return kept;
}

/// The body of a picture of lines: colours tell methods, dashes their tiers.
std::string lines_of(const std::vector<MeasureLine>& lines) {
    Blocks blocks;
    Palette palette;
    std::vector<std::string> curves;
    std::map<std::string, int> tiers;
    for (const MeasureLine& line : told_apart(lines)) {
        const std::string& method = line.way.method;
        std::string points;
        for (const auto& [at, value] : line.points)
            points += number(at) + " " + number(value) + "\n";
        curves.push_back(blocks.add(points) +
                         " using 1:2 with linespoints linewidth 2 pointtype 7 dashtype " +
                         std::to_string(++tiers[method]) + " linecolor rgb " +
                         (method.empty() ? quoted(FAINT) : palette(method)) + " title " +
                         quoted(method.empty() ? "mip chain" : label_of(line.way)));
    }
    return blocks.text() + joined(curves);
}

} // namespace

std::vector<MeasurePlot> measure_plots(const MeasureSummary& summary) {
    struct Task {
        const char *name, *title, *work;
    };
    std::vector<MeasurePlot> plots;
    const auto add = [&](const std::string& name, const std::string& title, const auto& script) {
        plots.push_back({name, title, script(title)});
    };
    for (const Task& task :
         {Task{"prefilter", "Prefilter", "one map"}, {"shade", "Shading", "512 x 512 sphere"}}) {
        const std::string name = task.name, subject = task.title;
        const auto lines = summary.errors_by_exponent(name);
        if (lines.empty()) continue;
        add(name + "-error-time", subject + ": error against time", [&](const std::string& title) {
            return errors_by_time(summary, summary.means(name), title, task.work);
        });
        add(name + "-error-exponent", subject + ": error against exponent",
            [&](const std::string& title) {
                return frame(summary, title, "Phong exponent n", ERROR_AXIS) + lines_of(lines);
            });
    }
    const auto costs = summary.costs_by_face();
    if (!costs.empty())
        add("prefilter-cost-face", "Prefilter: cost of one map against face size",
            [&](const std::string& title) {
                return frame(summary, title, "face of the environment's cube map, texels",
                             "ms (" + summary.clock() + ")") +
                       "set logscale x 2\n" + lines_of(costs);
            });
    return plots;
}

} // namespace lobelia::cli
