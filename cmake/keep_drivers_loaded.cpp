// Takes the place of the system's function in programs that are built with it (Sanitizers.cmake).
extern "C" int dlclose(void*);

extern "C" int dlclose(void*) {
    return 0;
}

// The validation layer (1.3.239) keeps cycles of its own records when the device is destroyed, and
// OpenEXR (3.1.5) loses what its constructors have made where they run out of memory. What drivers
// and we leak is still found.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libVkLayer_khronos_validation.so\n"
           "leak:libOpenEXR-\n";
}
