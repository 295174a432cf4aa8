// The pictures of docs/viewer.md, taken of the window on an X server without a screen:
//     viewer_pictures FOLDER

#include <cstdio>
#include <exception>

#include "support/run_program.h"
#include "viewer/session.h"

namespace lobelia::test {
namespace {

using Json = ViewerSession::Json;

class Photographer {
public:
    Photographer(const std::string& folder, const std::string& panorama)
        : folder_(folder),
          session_(desktop_, {LOBELIA_PANORAMAS "/" + panorama, "--size", "960x680"},
                   nowhere_.path(), {}) {
        session_.window();
        session_.wait_until_still();
    }
    ~Photographer() { session_.key("ctrl+q"); }

    ViewerSession& session() { return session_; }
    void choose(const std::string& list, const std::string& entry) {
        session_.click(list);
        session_.wait_for("the list", [&](const Json& frame) {
            return frame["controls"].contains(list + "." + entry);
        });
        session_.click(list + "." + entry);
        session_.wait_until_still();
    }
    void take(const std::string& name) {
        desktop_.run({"import", "-window", session_.window(), "PNG24:" + folder_ + "/" + name});
    }

private:
    Desktop desktop_;
    TemporaryFolder nowhere_;
    std::string folder_;
    ViewerSession session_;
};

void take_material(const std::string& folder) {
    Photographer photographer(folder, "forest.exr");
    photographer.choose("preset", "copper");
    photographer.session().move_to({950, 630});
    photographer.session().wait_until_still();
    photographer.take("viewer.png");
}

void take_split(const std::string& folder) {
    Photographer photographer(folder, "courtyard.exr");
    photographer.choose("preset", "glazed clay");
    photographer.choose("method", "kurt2019");
    photographer.choose("other", "two-tap");
    photographer.session().click("background.blurred");
    photographer.session().press_and_move({480, 60}, {600, 60}, 3);
    photographer.session().move_to({950, 630});
    photographer.session().wait_until_still();
    photographer.take("viewer-split.png");
}

void take_errors(const std::string& folder) {
    constexpr double EIGHT_APART = 1.0 / 64; // pixels of the reference
    Photographer photographer(folder, "courtyard.exr");
    ViewerSession& session = photographer.session();
    photographer.choose("method", "split-sum");
    photographer.choose("other", "two-tap");
    session.press_and_move({480, 60}, {620, 60}, 3);
    session.move_to({950, 630});
    session.key("e");
    for (bool known = false; !known;) {
        const double frame = session.last()["frame"];
        session.wait_for("a frame", [&](const Json& now) { return now["frame"] > frame; });
        const Json& reference = session.last()["reference"];
        known = reference.is_number() && reference > EIGHT_APART;
        session.take_frames();
    }
    photographer.take("viewer-errors.png");
}

} // namespace
} // namespace lobelia::test

int main(int count, char** arguments) {
    if (count != 2) return std::fprintf(stderr, "usage: viewer_pictures FOLDER\n"), 2;
    try {
        lobelia::test::take_material(arguments[1]);
        lobelia::test::take_split(arguments[1]);
        lobelia::test::take_errors(arguments[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "viewer_pictures: %s\n", error.what());
        return 1;
    }
}
