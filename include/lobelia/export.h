#pragma once

/// What is visible outside of the shared library. The target lobelia::shared sets LOBELIA_SHARED;
/// in the static library everything stays hidden, also in a shared object that it is linked into.
#ifdef LOBELIA_SHARED
#define LOBELIA_API __attribute__((visibility("default")))
#else
#define LOBELIA_API
#endif
