// Takes the place of the system's function in programs that are built with it (Sanitizers.cmake).
extern "C" int dlclose(void*);

extern "C" int dlclose(void*) {
    return 0;
}
