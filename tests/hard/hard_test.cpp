#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <regex>

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include "bench.h"
#include "page.h"

// Runs the catalogue. With --page=FILE a run writes docs/hard-cases.md.
namespace lobelia::hard {

void PrintTo(const Row& row, std::ostream* out) {
    *out << row.input << ": " << row.promise;
}

namespace {

Run seen; // what the rows gave

std::vector<Row> rows_to_run() {
    std::vector<Row> rows;
    for (const Kind& kind : catalogue())
        for (const Row& row : kind.rows)
            if (row.check) rows.push_back(row);
    return rows;
}

std::string digits(double value) {
    std::ostringstream text;
    text << std::setprecision(12) << value;
    return text.str();
}

class HardCase : public testing::TestWithParam<Row> {};
INSTANTIATE_TEST_SUITE_P(Rows, HardCase, testing::ValuesIn(rows_to_run()),
                         [](const auto& row) { return std::string(row.param.id); });

TEST_P(HardCase, KeepsItsPromise) {
    Findings& findings =
        seen.insert_or_assign(GetParam().id, Findings(GetParam().id)).first->second;
    GetParam().check(bench(), findings);
    EXPECT_GT(findings.points(), 0);
    RecordProperty("points", findings.points());
    RecordProperty("worst_exact", digits(findings.worst_exact));
    RecordProperty("worst_sharp", digits(findings.worst_sharp));
    RecordProperty("values", digits(double(findings.texels)));
    RecordProperty("unsound", digits(double(findings.non_finite)));
    if (bench().has_gpu())
        for (const std::string& message : bench().gpu().take_messages()) ADD_FAILURE() << message;
}

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

const std::filesystem::path SOURCES = LOBELIA_SOURCE_FOLDER;

TEST(HardCasesPage, HasEveryRowAndNoOther) {
    const std::string page = text_of(SOURCES / "docs/hard-cases.md");
    std::size_t rows = 0;
    for (const Kind& kind : catalogue())
        for (const Row& row : kind.rows) {
            EXPECT_NE(page.find("\n" + promise_line(row)), std::string::npos)
                << row.id << " is not in docs/hard-cases.md as it is here: "
                << "cmake --build --preset release --target update-hard-cases";
            ++rows;
        }
    const std::regex line("\n\\| [A-Z][0-9]{2} \\|");
    EXPECT_EQ(rows, std::size_t(std::distance(std::sregex_iterator(page.begin(), page.end(), line),
                                              std::sregex_iterator())));
}

TEST(HardCasesPage, AccountsForEveryRowInOneWay) {
    int rows = 0, absent = 0;
    for (const Kind& kind : catalogue())
        for (const Row& row : kind.rows) {
            ++rows;
            absent += row.absent != nullptr;
            EXPECT_TRUE(row.check || row.held_by || row.absent) << row.id;
            EXPECT_FALSE(row.absent && (row.check || row.held_by)) << row.id;
        }
    RecordProperty("rows", rows);
    RecordProperty("absent_rows", absent);
}

TEST(Findings, HearWhatIsNoRadiance) {
    Findings found("any row");
    const float bad[] = {NAN, INFINITY, -1.0f, 0.0f};
    EXPECT_NONFATAL_FAILURE(found.sound(bad), "no radiance");
    EXPECT_EQ(found.non_finite, 3u);
}

// "TEST_F(Suite, Name)" of all tests, as "Suite.Name".
std::string all_tests() {
    std::string names;
    const std::regex test("\nTEST(?:_F|_P)?\\(\\s*(\\w+),\\s*(\\w+)\\)");
    for (const auto& entry : std::filesystem::recursive_directory_iterator(SOURCES / "tests")) {
        if (entry.path().extension() != ".cpp") continue;
        const std::string text = text_of(entry.path());
        for (std::sregex_iterator i(text.begin(), text.end(), test), end; i != end; ++i)
            names += "\n" + (*i)[1].str() + "." + (*i)[2].str() + "\n";
    }
    return names;
}

TEST(HardCasesPage, NamesTestsThatExist) {
    const std::string tests = all_tests();
    for (const Kind& kind : catalogue())
        for (const Row& row : kind.rows) {
            if (!row.held_by) continue;
            EXPECT_NE(tests.find(std::string("\n") + row.held_by + "\n"), std::string::npos)
                << row.id << " is held by " << row.held_by;
        }
}

} // namespace
} // namespace lobelia::hard

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    std::string page;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument.starts_with("--page="))
            page = argument.substr(7);
        else {
            std::cerr << "hard_tests: what is " << argument << "? give --page=FILE\n";
            return 2;
        }
    }
    const int failed = RUN_ALL_TESTS();
    lobelia::hard::close_bench();
    if (!page.empty()) {
        const std::string text =
            lobelia::hard::page(lobelia::hard::seen, lobelia::hard::text_of(page));
        std::ofstream(page) << text;
    }
    return failed;
}
