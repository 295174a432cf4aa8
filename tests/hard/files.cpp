#include "files.h"

#include <ctime>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <lobelia/host/read.h>

namespace lobelia::hard {

namespace {

double cpu_milliseconds() {
    return 1e3 * double(std::clock()) / CLOCKS_PER_SEC;
}

} // namespace

RefusalCost cost_of_refusing(const std::string& path) {
    int ends[2];
    if (::pipe(ends) != 0) return {};
    RefusalCost cost;
    const pid_t child = ::fork();
    if (child == 0) {
        rusage before{}, after{};
        ::getrusage(RUSAGE_SELF, &before);
        const double start = cpu_milliseconds();
        cost.refused = !host::read_environment(path);
        cost.cpu_ms = cpu_milliseconds() - start;
        ::getrusage(RUSAGE_SELF, &after);
        cost.megabytes = double(after.ru_maxrss - before.ru_maxrss) / 1024;
        const bool told = ::write(ends[1], &cost, sizeof cost) == sizeof cost;
        ::_exit(told ? 0 : 1);
    }
    ::close(ends[1]);
    if (::read(ends[0], &cost, sizeof cost) != ssize_t(sizeof cost)) cost = {};
    ::close(ends[0]);
    ::waitpid(child, nullptr, 0);
    return cost;
}

void cheaply_refused(Findings& found, const std::string& path, const std::string& words) {
    const auto environment = host::read_environment(path);
    found.refused(environment, words);
    found.refused(environment, path + ": ");
    const RefusalCost cost = cost_of_refusing(path);
    found.holds(cost.refused, "refused in a process of its own, too");
    found.within(cost.cpu_ms, 50);
    found.within(cost.megabytes, 16);
}

host::Environment read(const std::string& path) {
    return value_of(host::read_environment(path));
}

double plain_mean(const host::Image& image) {
    double sum = 0;
    for (std::size_t i = 0; i < image.texels.size(); ++i)
        if (i % 4 != 3) sum += double(image.texels[i]);
    return sum / (double(image.texels.size()) * 0.75);
}

std::string make_file(const test::TemporaryFolder& folder,
                      const std::vector<test::Channel>& channels,
                      const std::function<void(Imf::Header&)>& change) {
    Imf::Header header(WIDTH, HEIGHT);
    if (change) change(header);
    test::make_exr(folder / "a.exr", header, channels);
    return folder / "a.exr";
}

} // namespace lobelia::hard
