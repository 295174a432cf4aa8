// What the thread sanitizer is there for: it must report this, or it sees nothing.
#include <thread>

int main() {
    int count = 0;
    const auto work = [&] {
        for (int i = 0; i < 1000; ++i) ++count;
    };
    std::thread other(work);
    work();
    other.join();
    return count > 0 ? 0 : 1;
}
