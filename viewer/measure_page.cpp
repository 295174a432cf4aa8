#include "measure_page.h"

#include <algorithm>
#include <cstdio>

namespace lobelia::cli {

namespace {

constexpr const char* STYLE = R"(
body { font: 16px/1.5 system-ui, sans-serif; max-width: 60em; margin: 0 auto; padding: 1em;
       color: #222; background: #fff }
h1, h2 { line-height: 1.2 }
figure { margin: 1.5em 0 }
svg { display: block; width: 100%; height: auto }
.table { overflow-x: auto }
table { border-collapse: collapse; font-variant-numeric: tabular-nums }
th, td { padding: .2em .8em; text-align: right; border-bottom: 1px solid #ddd }
th:first-child, td:first-child { text-align: left }
)";

std::string escaped(const std::string& text) {
    std::string result;
    for (const char character : text) switch (character) {
        case '&': result += "&amp;"; break;
        case '<': result += "&lt;"; break;
        case '>': result += "&gt;"; break;
        default: result += character;
        }
    return result;
}

// The image alone, without what a file of its own begins with.
std::string inlined(const std::string& svg) {
    const std::size_t start = svg.find("<svg");
    return start == std::string::npos ? svg : svg.substr(start);
}

std::string rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", value);
    // Thousands stay readable without an exponent.
    if (value >= 100.0) std::snprintf(text, sizeof text, "%.0f", value);
    return text;
}

std::string means_table(const std::vector<MeasureMean>& means) {
    const std::vector<MeasureMean> front = pareto_front(means);
    std::string rows;
    for (const MeasureMean& mean : means) {
        const bool best = std::any_of(front.begin(), front.end(), [&](const MeasureMean& other) {
            return other.way == mean.way;
        });
        rows += "<tr><td>" + escaped(label_of(mean.way)) + "</td><td>" + rounded(mean.ms) +
                "</td><td>" + (mean.rms ? rounded(*mean.rms) : "exact") + "</td><td>" +
                (best ? "yes" : "") + "</td></tr>\n";
    }
    return "<div class=\"table\"><table>\n<tr><th>method</th><th>ms</th><th>error</th>"
           "<th>on the front</th></tr>\n" +
           rows + "</table></div>\n";
}

std::string advantages_table(const std::vector<MeasureAdvantage>& advantages) {
    if (advantages.empty()) return "";
    std::string rows;
    for (const MeasureAdvantage& one : advantages)
        rows += "<tr><td>chain " + escaped(one.quality) + "</td><td>" + rounded(one.error) +
                "</td><td>" + (one.at_least ? "more than " : "") + rounded(one.time) +
                "</td></tr>\n";
    return "<p>One map by filtered importance sampling, n from 16 to 1024:</p>\n"
           "<div class=\"table\"><table>\n<tr><th>beside</th><th>times the error, in its "
           "time</th><th>times the time, for its error</th></tr>\n" +
           rows + "</table></div>\n";
}

} // namespace

std::string measure_page(const MeasureSummary& summary, const std::vector<DrawnPlot>& plots) {
    std::string environments;
    for (const std::string& name : summary.environments())
        environments += (environments.empty() ? "" : ", ") + name;
    std::string body = "<h1>What accuracy costs in time</h1>\n<p>Measured on " +
                       escaped(summary.device()) + ", environments: " + escaped(environments) +
                       ". Times are " + escaped(summary.clock()) +
                       "; errors are the root mean square of |value - exact| / (|exact| + 1e-3 "
                       "mean). Both are geometric means over environments and exponents. Nothing "
                       "is at once faster and more exact than what is on the front. Every single "
                       "figure: measure.csv, measure.json.</p>\n";
    body += advantages_table(summary.advantages());
    for (const DrawnPlot& drawn : plots)
        body += "<figure>" + inlined(drawn.svg) + "<figcaption>" + escaped(drawn.plot.caption) +
                "</figcaption></figure>\n";
    for (const char* const task : {"prefilter", "shade"}) {
        const auto means = summary.means(task);
        if (!means.empty()) body += "<h2>" + std::string(task) + "</h2>\n" + means_table(means);
    }
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<title>Lobelia: what accuracy costs in time</title>\n<style>" +
           std::string(STYLE) + "</style>\n</head>\n<body>\n" + body + "</body>\n</html>\n";
}

} // namespace lobelia::cli
