#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

#include <gtest/gtest.h>

// The tables of docs/accuracy.md that come from docs/measure.csv, computed anew.
namespace lobelia::test {
namespace {

using Row = std::map<std::string, std::string>; // by the names of the columns

std::vector<std::string> split(const std::string& line, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : line) {
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

/// Of environments as they are: face 256, and 512 for quality high, not those of the sweep.
std::vector<Row> measured() {
    std::ifstream file(LOBELIA_SOURCE_FOLDER "/docs/measure.csv");
    std::string line;
    std::getline(file, line);
    const std::vector<std::string> names = split(line, ',');
    std::vector<Row> rows;
    while (std::getline(file, line)) {
        const std::vector<std::string> fields = split(line, ',');
        Row row;
        for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = fields.at(i);
        if (row["face_size"] == (row["quality"] == "high" ? "512" : "256")) rows.push_back(row);
    }
    return rows;
}

std::string name_of(const Row& row) {
    std::string name = row.at("method");
    for (const char* more : {"quality", "samples"})
        if (!row.at(more).empty()) name += " " + row.at(more);
    return name;
}

double number(const Row& row, const char* column) {
    return std::stod(row.at(column));
}

double geometric_mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += std::log(value);
    return std::exp(sum / double(values.size()));
}

std::string text_of(const char* format, double value) {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

/// 7.1e-4, and 1.2 as it is.
std::string error_text(double error) {
    if (error >= 0.1) return text_of("%.2g", error);
    const std::string text = text_of("%.1e", error);
    return text.substr(0, 5) + text.substr(6); // one digit of the exponent is enough
}

std::string large_text(double value) {
    return text_of(value >= 100 ? "%.0f" : "%.2g", value);
}

/// Lines of the page's table whose header begins with `title`, without header and rule.
std::vector<std::string> table(const std::string& title) {
    std::ifstream file(LOBELIA_SOURCE_FOLDER "/docs/accuracy.md");
    std::vector<std::string> lines;
    bool inside = false;
    for (std::string line; std::getline(file, line);) {
        inside = line.starts_with("| " + title) || (inside && line.starts_with("|"));
        if (inside) lines.push_back(line);
    }
    lines.erase(lines.begin(),
                lines.begin() + std::ptrdiff_t(std::min<std::size_t>(2, lines.size())));
    return lines;
}

std::vector<std::string> means(const std::string& task) {
    std::vector<std::string> names, lines;
    const std::vector<Row> rows = measured();
    for (const Row& row : rows)
        if (row.at("task") == task &&
            std::find(names.begin(), names.end(), name_of(row)) == names.end())
            names.push_back(name_of(row));
    for (const std::string& name : names) {
        std::vector<double> times, errors;
        for (const Row& row : rows) {
            if (row.at("task") != task || name_of(row) != name) continue;
            times.push_back(number(row, "cpu_ms"));
            if (number(row, "rms") > 0) errors.push_back(number(row, "rms"));
        }
        lines.push_back("| " + name + " | " + large_text(geometric_mean(times)) + " | " +
                        (errors.empty() ? "exact" : error_text(geometric_mean(errors))) + " |");
    }
    return lines;
}

struct Point {
    double ms, error;
};

/// The error of sampling in `ms`: on a line through its points on logarithmic axes.
double error_in(double ms, const std::vector<Point>& sampled) {
    if (ms <= sampled.front().ms) return sampled.front().error;
    for (std::size_t i = 1; i < sampled.size(); ++i) {
        const Point &a = sampled[i - 1], &b = sampled[i];
        if (ms > b.ms) continue;
        const double share = std::log(ms / a.ms) / std::log(b.ms / a.ms);
        return a.error * std::pow(b.error / a.error, share);
    }
    return sampled.back().error;
}

/// When that line comes down to `error`; nothing where it ends above.
std::optional<double> time_for(double error, const std::vector<Point>& sampled) {
    if (sampled.front().error <= error) return sampled.front().ms;
    for (std::size_t i = 1; i < sampled.size(); ++i) {
        const Point &a = sampled[i - 1], &b = sampled[i];
        if (b.error > error) continue;
        const double share = std::log(error / a.error) / std::log(b.error / a.error);
        return a.ms * std::pow(b.ms / a.ms, share);
    }
    return std::nullopt;
}

/// Of n from 16 to 1024. Where no number of samples is as good as the chain, the time of the most.
std::string advantage(const std::string& quality) {
    std::vector<double> errors, times;
    bool all_reached = true;
    const std::vector<Row> rows = measured();
    for (const Row& row : rows) {
        const double n = number(row, "exponent");
        if (row.at("method") != "chain" || row.at("quality") != quality || n < 16 || n > 1024)
            continue;
        std::vector<Point> sampled;
        for (const Row& other : rows)
            if (other.at("method") == "filtered-importance" &&
                other.at("environment") == row.at("environment") &&
                other.at("exponent") == row.at("exponent"))
                sampled.push_back({number(other, "cpu_ms"), number(other, "rms")});
        const double ms = number(row, "cpu_ms"), error = number(row, "rms");
        const auto time = time_for(error, sampled);
        errors.push_back(error_in(ms, sampled) / error);
        times.push_back(time.value_or(sampled.back().ms) / ms);
        all_reached = all_reached && time;
    }
    return "| " + quality + " | " + large_text(geometric_mean(errors)) +
           (all_reached ? " | " : " | more than ") + large_text(geometric_mean(times)) + " |";
}

TEST(MeasuredPageTest, HasTheMeansOfThePrefilter) {
    EXPECT_EQ(table("prefilter, one map"), means("prefilter"));
}

TEST(MeasuredPageTest, HasTheMeansOfShading) {
    EXPECT_EQ(table("shading, 512 x 512"), means("shade"));
}

TEST(MeasuredPageTest, HasTheChainsAdvantage) {
    EXPECT_EQ(table("chain beside sampling"),
              (std::vector{advantage("fast"), advantage("normal"), advantage("high")}));
}

TEST(MeasuredPageTest, IsWhatTheReadmeSays) {
    std::ifstream file(LOBELIA_SOURCE_FOLDER "/README.md");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::string times = split(advantage("normal"), '|').at(2);
    EXPECT_NE(text.find("sampling errs\n" + times.substr(1) + "times as much"), std::string::npos)
        << times;
}

} // namespace
} // namespace lobelia::test
