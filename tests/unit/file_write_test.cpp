#include <csignal>
#include <thread>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <lobelia/host/read.h>
#include <lobelia/host/write.h>

#include "file_fixtures.h"

namespace lobelia::test {

using host::Content;
using host::Image;
using host::Layout;
using host::Part;

namespace {

Image make_image(Layout layout, unsigned width, unsigned height, float first = 0.25f) {
    Image image{layout, width, height, layout == Layout::cube ? 6u : 1u, {}};
    for (std::size_t i = 0; i < std::size_t(width) * height * image.layers; ++i)
        image.texels.insert(image.texels.end(),
                            {first + float(i), 1e9f / (1.0f + float(i)), 1e-30f, 1.0f});
    return image;
}

std::string text_attribute(const Imf::Header& header, const char* name) {
    const auto* attribute = header.findTypedAttribute<Imf::StringAttribute>(name);
    return attribute ? attribute->value() : "(none)";
}

// No file of this process may grow beyond some bytes while this lives, as on a full disk.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }

private:
    rlimit before_{};
};

} // namespace

class FileWriteTest : public FileTest {
protected:
    auto write_one(const std::string& name, const Image& image,
                   Content content = Content::environment) const {
        const Part part{"", &image};
        return host::write_exr(name, {&part, 1}, content);
    }
};

TEST_F(FileWriteTest, AnEnvironmentComesBackBitForBit) {
    for (const Layout layout : {Layout::latlong, Layout::cube}) {
        const Image image = make_image(layout, layout == Layout::cube ? 7 : 14, 7);
        ASSERT_TRUE(write_one(path("a.exr"), image));
        const auto environment = host::read_environment(path("a.exr"));
        ASSERT_TRUE(environment) << environment.error().message;
        EXPECT_EQ(environment->image.layout, layout);
        EXPECT_EQ(environment->image.layers, image.layers);
        EXPECT_EQ(environment->image.width, image.width);
        EXPECT_EQ(environment->image.height, image.height);
        EXPECT_EQ(environment->image.texels, image.texels);
        EXPECT_TRUE(environment->notices.empty());
        EXPECT_EQ(files(), 1u);
    }
}

TEST_F(FileWriteTest, AnEnvironmentSaysWhatItIs) {
    const Image latlong = make_image(Layout::latlong, 4, 2);
    const Part part{"", &latlong};
    ASSERT_TRUE(host::write_exr(path("a.exr"), {&part, 1}, Content::environment,
                                {{"lobelia:exponent", "16"}}));
    const Imf::InputFile file(path("a.exr").c_str());
    EXPECT_EQ(Imf::envmap(file.header()), Imf::ENVMAP_LATLONG);
    EXPECT_EQ(text_attribute(file.header(), "lobelia:sampling"), "texel centres");
    EXPECT_EQ(text_attribute(file.header(), "lobelia:exponent"), "16");
    EXPECT_EQ(file.header().compression(), Imf::ZIP_COMPRESSION);
    EXPECT_FALSE(file.header().channels().findChannel("A"));
    EXPECT_EQ(file.header().channels().findChannel("R")->type, Imf::FLOAT);
}

TEST_F(FileWriteTest, APictureHasAlphaAndIsNoEnvironment) {
    ASSERT_TRUE(write_one(path("a.exr"), make_image(Layout::latlong, 3, 3), Content::picture));
    const Imf::InputFile file(path("a.exr").c_str());
    EXPECT_TRUE(file.header().channels().findChannel("A"));
    EXPECT_FALSE(Imf::hasEnvmap(file.header()));
    EXPECT_EQ(text_attribute(file.header(), "lobelia:sampling"), "(none)");
}

TEST_F(FileWriteTest, SeveralPartsKeepTheirNamesAndTexels) {
    const Image sharp = make_image(Layout::cube, 4, 4);
    const Image blurred = make_image(Layout::cube, 2, 2, 5.0f);
    const Part parts[] = {{"n=64", &sharp}, {"n=16", &blurred}};
    const auto written = host::write_exr(path("a.exr"), parts, Content::environment);
    ASSERT_TRUE(written) << written.error().message;
    Imf::MultiPartInputFile file(path("a.exr").c_str());
    ASSERT_EQ(file.parts(), 2);
    EXPECT_EQ(file.header(0).name(), "n=64");
    EXPECT_EQ(file.header(1).name(), "n=16");
    EXPECT_EQ(Imf::envmap(file.header(1)), Imf::ENVMAP_CUBE);
    EXPECT_EQ(file.header(1).dataWindow(), Imath::Box2i({0, 0}, {1, 11}));
    const auto first = host::read_environment(path("a.exr"));
    ASSERT_TRUE(first) << first.error().message;
    EXPECT_EQ(first->image.texels, sharp.texels);
}

TEST_F(FileWriteTest, RefusesImagesAndNamesThatDoNotFit) {
    Image image = make_image(Layout::latlong, 4, 2);
    const Part twice[] = {{"a", &image}, {"a", &image}};
    const Part nameless[] = {{"a", &image}, {"", &image}};
    const Part empty{"", nullptr};
    EXPECT_FALSE(host::write_exr(path("a.exr"), {}, Content::picture));
    EXPECT_FALSE(host::write_exr(path("a.exr"), {&empty, 1}, Content::picture));
    EXPECT_FALSE(host::write_exr(path("a.exr"), twice, Content::picture));
    EXPECT_FALSE(host::write_exr(path("a.exr"), nameless, Content::picture));
    EXPECT_FALSE(host::write_exr(path("a.exr"), {twice, 1}, Content::picture, {{"channels", "x"}}));
    EXPECT_FALSE(host::write_exr(path("a.exr"), {twice, 1}, Content::picture, {{"", "x"}}));
    image.texels.pop_back();
    EXPECT_FALSE(write_one(path("a.exr"), image));
    image = make_image(Layout::cube, 4, 2);
    EXPECT_FALSE(write_one(path("a.exr"), image));
    EXPECT_EQ(files(), 0u);
}

TEST_F(FileWriteTest, AFullDiskLeavesTheOldFileAndNothingElse) {
    const Image image = make_image(Layout::latlong, 64, 32);
    {
        const FullDisk disk(1000);
        const auto written = write_one(path("a.exr"), image);
        ASSERT_FALSE(written);
        EXPECT_EQ(written.error().message.find(path("a.exr") + ": "), 0u);
        EXPECT_EQ(files(), 0u);
    }
    const std::string old = bytes_of(write("a.exr", "old"));
    {
        const FullDisk disk(0);
        EXPECT_FALSE(write_one(path("a.exr"), image));
        EXPECT_FALSE(host::write_png(path("a.exr"), image, 0));
        const Image cube = make_image(Layout::cube, 4, 4);
        EXPECT_FALSE(host::write_ktx2(path("a.exr"), {&cube, 1}));
    }
    EXPECT_EQ(bytes_of(path("a.exr")), old);
    EXPECT_EQ(files(), 1u);
    EXPECT_FALSE(write_one("/dev/full", image));
}

TEST_F(FileWriteTest, ReplacesByRenamingAndKeepsPermissions) {
    const Image image = make_image(Layout::latlong, 4, 2);
    write("a.exr", "old");
    ASSERT_EQ(::chmod(path("a.exr").c_str(), 0640), 0);
    ASSERT_EQ(::link(path("a.exr").c_str(), path("other name").c_str()), 0);
    ASSERT_TRUE(write_one(path("a.exr"), image));
    EXPECT_EQ(bytes_of(path("other name")), "old"); // never written into
    struct stat state {};
    ASSERT_EQ(::stat(path("a.exr").c_str(), &state), 0);
    EXPECT_EQ(state.st_mode & 0777, 0640u);
    EXPECT_EQ(files(), 2u);
}

TEST_F(FileWriteTest, FollowsLinksAndRefusesFolders) {
    const Image image = make_image(Layout::latlong, 4, 2);
    ASSERT_EQ(::symlink("target.exr", path("link.exr").c_str()), 0); // not there yet
    ASSERT_EQ(::symlink("loop.exr", path("loop.exr").c_str()), 0);
    ASSERT_TRUE(write_one(path("link.exr"), image));
    ASSERT_TRUE(write_one(path("link.exr"), image));
    EXPECT_TRUE(host::read_environment(path("target.exr")));
    EXPECT_TRUE(std::filesystem::is_symlink(path("link.exr")));
    EXPECT_EQ(files(), 3u);
    EXPECT_FALSE(write_one(path("loop.exr"), image));
    EXPECT_FALSE(write_one(path(""), image));
    EXPECT_FALSE(write_one(path("no such folder/a.exr"), image));
    EXPECT_FALSE(write_one("/proc/a.exr", image)); // takes no files from anyone
    EXPECT_FALSE(write_one("", image));
    EXPECT_TRUE(write_one("/dev/null", image));
}

TEST_F(FileWriteTest, APipeThatNobodyReadsIsAnErrorAndNotASignal) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    ::close(ends[0]);
    const Image image = make_image(Layout::latlong, 4, 2);
    EXPECT_FALSE(write_one("/proc/self/fd/" + std::to_string(ends[1]), image));
    ::close(ends[1]);
}

TEST_F(FileWriteTest, WritersOfOnePathNeverMix) {
    const Image images[] = {make_image(Layout::latlong, 32, 16, 1.0f),
                            make_image(Layout::latlong, 32, 16, 2.0f)};
    std::vector<std::thread> writers;
    for (const Image& image : images)
        writers.emplace_back([&] {
            for (int i = 0; i < 20; ++i) EXPECT_TRUE(write_one(path("a.exr"), image));
        });
    for (std::thread& writer : writers) writer.join();
    const auto environment = host::read_environment(path("a.exr"));
    ASSERT_TRUE(environment) << environment.error().message;
    EXPECT_TRUE(environment->image.texels == images[0].texels ||
                environment->image.texels == images[1].texels);
    EXPECT_EQ(files(), 1u);
}

} // namespace lobelia::test
