// Names a device by the installed lobelia::host.
#include <cstdio>

#include <lobelia/host/gpu.h>

int main() {
    const auto gpus = lobelia::host::list_gpus();
    if (!gpus) return 1;
    std::printf("%s\n", gpus->front().name.c_str());
}
