#include <filesystem>

#include <lobelia/host/read.h>
#include <lobelia/host/write.h>

#include "files.h"

// H: files and processes.
namespace lobelia::hard {
namespace {

using test::TemporaryFolder;

host::Outcome<Done> write(const std::string& path, const host::Image& image) {
    const host::Part part{.image = &image};
    return host::write_exr(path, {&part, 1}, host::Content::environment);
}

void odd_names(Bench&, Findings& found) {
    const TemporaryFolder folder;
    const host::Image image = image_of(oracle::random_panorama(Scene::noise, 8, 4, 101));
    for (const std::string& name :
         {std::string("with spaces.exr"), std::string("\xc3\xbc\xe6\x97\xa5.exr"),
          std::string("\xff\xfe not utf-8.exr"), std::string("two\nlines.exr"),
          std::string("-o.exr"), std::string("'\"$(x)`.exr"), std::string(200, 'n') + ".exr"}) {
        found.at(name.substr(0, 12));
        found.holds(bool(write(folder / name, image)), "is written");
        const auto back = host::read_environment(folder / name);
        found.holds(back && back->image.texels == image.texels, "and read");
    }
    found.at("a name too long");
    found.refused(write(folder / (std::string(300, 'n') + ".exr"), image), "");
    found.at("no name");
    found.refused(write("", image), "");
    found.holds(folder.names().size() == 7, "and nothing else is left");
}

void onto_itself(Bench&, Findings& found) {
    const TemporaryFolder folder;
    const host::Image image = image_of(oracle::random_panorama(Scene::noise, 8, 4, 102));
    found.at("read, then written to the same path");
    found.holds(bool(write(folder / "a.exr", image)), "is written");
    const host::Image first = value_of(host::read_environment(folder / "a.exr")).image;
    found.holds(bool(write(folder / "a.exr", first)), "over itself");
    found.holds(value_of(host::read_environment(folder / "a.exr")).image.texels == image.texels,
                "the same bytes");
    found.holds(folder.names().size() == 1, "and nothing else is left");
}

void no_permission(Bench&, Findings& found) {
    // /proc takes no files, not even root's.
    const host::Image image = even_panorama(2, 1, 1, 1, 1);
    for (const char* path : {"/proc/a.exr", "/proc/self/fd/a.exr", "/nowhere/a.exr"}) {
        found.at(path);
        found.refused(write(path, image), path);
    }
}

} // namespace

Kind processes() {
    return {"Files and processes",
            {
                {"H01", "folders that take no file", "an error that names the path", no_permission},
                {"H02", "a full disk", "the old file, and nothing else", nullptr,
                 "FileWriteTest.AFullDiskLeavesTheOldFileAndNothingElse"},
                {"H03", "a limit on the size of files", "an error, not a signal", nullptr,
                 "ProcessTest.KeepsTheOldFileBeyondALimitOnFiles"},
                {"H04", "paths with spaces, newlines, quotes, no UTF-8, 200 letters",
                 "written and read", odd_names},
                {"H05", "several writers of one path", "one of them whole, never a mixture",
                 nullptr, "FileWriteTest.WritersOfOnePathNeverMix"},
                {"H07", "output onto the input", "the same bytes", onto_itself},
                {"H08", "links, devices, pipes, a full standard output",
                 "links stay; the rest is an error", nullptr,
                 "FileWriteTest.FollowsLinksAndRefusesFolders"},
            }};
}

} // namespace lobelia::hard
