#include <atomic>
#include <filesystem>
#include <thread>

#include <sys/stat.h>
#include <unistd.h>

#include <lobelia/host/read.h>

#include "files.h"

// C29, C30: paths that are not a picture, or not always.
namespace lobelia::hard {
namespace {

using host::read_environment;
using test::colour_channels;
using test::corpus;
using test::TemporaryFolder;

void no_pictures(Bench&, Findings& found) {
    const TemporaryFolder folder;
    const std::string fifo = folder / "fifo", loop = folder / "loop";
    found.holds(::mkfifo(fifo.c_str(), 0600) == 0 && ::symlink("loop", loop.c_str()) == 0, "made");
    test::write_bytes(folder / "empty", "");
    test::write_bytes(folder / "text.exr", "hello\n");
    for (const std::string& path :
         {fifo, loop, folder.path(), folder / "none", folder / "empty", folder / "text.exr",
          std::string("/dev/zero"), std::string("/dev/null")}) {
        found.at(path == folder.path() ? "a folder" : std::filesystem::path(path).filename());
        cheaply_refused(found, path);
    }
    found.at("an OpenEXR file called .hdr");
    std::filesystem::copy_file(corpus("const.exr"), folder / "a.hdr");
    found.near(plain_mean(read(folder / "a.hdr").image), 1, 1e-6);
}

void changing_file(Bench&, Findings& found) {
    // Shortened and restored all the while: what comes back is whole or refused.
    const TemporaryFolder folder;
    const std::string whole = test::bytes_of(make_file(folder, colour_channels()));
    const std::vector<float> texels = read(folder / "a.exr").image.texels;
    std::atomic<bool> stop = false;
    std::thread other([&] {
        while (!stop) {
            if (::truncate((folder / "a.exr").c_str(), off_t(whole.size() / 2)) != 0) return;
            test::write_bytes(folder / "a.exr", whole);
        }
    });
    found.at("200 reads");
    bool sound = true;
    for (int i = 0; i < 200; ++i) {
        const auto environment = read_environment(folder / "a.exr");
        sound = sound && (!environment || environment->image.texels == texels);
    }
    stop = true;
    other.join();
    found.holds(sound, "never a part");
}

} // namespace

Kind not_pictures() {
    return {"What is no picture",
            {
                {"C29", "pipes, loops, folders, devices, empty files, another ending",
                 "refused without waiting; content decides, not the ending", no_pictures},
                {"C30", "a file that another program shortens and restores", "whole or refused",
                 changing_file},
            }};
}

} // namespace lobelia::hard
