#include "plan_table.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include "tolerance.h"

namespace lobelia::cli {

namespace {

using Row = std::vector<std::string>;

/// Columns as wide as they need to be: the first to the left, the others to the right.
std::string in_columns(const std::vector<Row>& rows) {
    std::vector<std::size_t> widths;
    for (const Row& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (i == widths.size()) widths.push_back(0);
            widths[i] = std::max(widths[i], row[i].size());
        }
    std::string text;
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string gap(widths[i] - row[i].size(), ' ');
            if (i == 0)
                text += row[i] + (row.size() > 1 ? gap : "");
            else
                text += "  " + gap + row[i];
        }
        text += "\n";
    }
    return text;
}

/// With two digits after the point, whatever the locale.
std::string hundredths(double value) {
    char text[64];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, 2);
    return std::string(text, end.ptr);
}

std::string megabytes(std::uint64_t bytes) {
    return hundredths(double(bytes) * 1e-6);
}

double time_of(const host::PassReport& pass) {
    return pass.gpu_ms.value_or(pass.cpu_ms.value_or(0.0));
}

} // namespace

std::string plan_table(const host::WorkPlan& plan) {
    std::vector<Row> rows{{"pass", "invocations", "MB read", "MB written", "ms"}};
    host::PassReport all;
    double milliseconds = 0;
    for (const host::PassReport& pass : plan.report.passes) {
        rows.push_back({pass.name, std::to_string(pass.invocations), megabytes(pass.bytes_read),
                        megabytes(pass.bytes_written), hundredths(time_of(pass))});
        all.invocations += pass.invocations;
        all.bytes_read += pass.bytes_read;
        all.bytes_written += pass.bytes_written;
        milliseconds += time_of(pass);
    }
    rows.push_back({std::to_string(plan.report.passes.size()) + " passes",
                    std::to_string(all.invocations), megabytes(all.bytes_read),
                    megabytes(all.bytes_written), hundredths(milliseconds)});
    std::vector<Row> images{{"image", "size", "layers", "levels", "format", "MB", "lifetime"}};
    for (const host::ImageReport& image : plan.report.images)
        images.push_back({image.name,
                          std::to_string(image.width) + "x" + std::to_string(image.height),
                          std::to_string(image.layers), std::to_string(image.levels), image.format,
                          megabytes(image.bytes), image.lifetime});
    return in_columns(rows) + "\n" + in_columns(images) +
           "\nexpected error: " + error_text(plan.report.expected_error) + "\n";
}

std::string reasons_table(const host::WorkPlan& plan) {
    std::vector<Row> rows{{"effect", "", "ms", "MB"}};
    std::string text;
    for (const host::PlanReason& reason : plan.reasons) {
        const bool known = reason.milliseconds > 0 || reason.bytes > 0;
        rows.push_back({reason.effect + ": " + reason.why, reason.in ? "in" : "out",
                        known ? hundredths(reason.milliseconds) : "",
                        known ? megabytes(reason.bytes) : ""});
    }
    return "\n" + in_columns(rows);
}

} // namespace lobelia::cli
