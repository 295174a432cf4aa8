#include "page.h"

#include <algorithm>
#include <sstream>

namespace lobelia::hard {

namespace {

constexpr const char* HEAD = R"(# Hard cases

What is hard for an image-based light, what is promised of it, and how near the library comes to the
end of its promise. The rows are data of the tests (`tests/hard/`); this page is written by a run of
all of them:

    cmake --build --preset release --target update-hard-cases

`worst` is the error that came nearest to what is allowed of it, and that; `exact` where the promise
is one of bytes, `refused` where it is an error that says what is wrong and what to do; "of 16" and
"of 50" are the megabytes and milliseconds that a refusal took. A test's name stands where another
test holds the promise. Errors are relative unless the promise says otherwise;
"the map" is what the prefilter stores, in halves, "exact" the direct integration.
)";

std::string number(double value) {
    std::ostringstream out;
    out.precision(2);
    out << value;
    return out.str();
}

// The end of the row's line on the page `before`, or nothing.
std::string kept(const Row& row, const std::string& before) {
    const std::string line = "\n" + promise_line(row);
    const std::size_t at = before.find(line);
    if (at == std::string::npos) return "";
    const std::size_t from = at + line.size();
    return before.substr(from, before.find(" |\n", from) - from);
}

std::string measured(const Row& row, const Run& run, const std::string& before) {
    const auto found = run.find(row.id);
    if (row.check && found == run.end()) return kept(row, before);
    if (row.absent) return std::string(" | does not apply: ") + row.absent;
    std::string text = found == run.end() ? " | " : std::to_string(found->second.points()) + " | ";
    if (found != run.end()) {
        const Findings& findings = found->second;
        if (findings.only_refusals())
            text += "refused";
        else if (findings.allowed() == 0)
            text += "exact";
        else
            text += number(findings.worst()) + " of " + number(findings.allowed());
    }
    if (row.held_by) text += std::string(found == run.end() ? "" : "; ") + "`" + row.held_by + "`";
    return text;
}

} // namespace

std::string promise_line(const Row& row) {
    return std::string("| ") + row.id + " | " + row.input + " | " + row.promise + " | ";
}

std::string page(const Run& run, const std::string& before) {
    std::string text = HEAD;
    for (const Kind& kind : catalogue()) {
        text += std::string("\n## ") + kind.title +
                "\n\n| | case | promise | points | worst |\n| --- | --- | --- | --- | --- |\n";
        for (const Row& row : kind.rows)
            text += promise_line(row) + measured(row, run, before) + " |\n";
    }
    return text;
}

} // namespace lobelia::hard
