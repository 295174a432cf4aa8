#pragma once

#include <vector>

#include "findings.h"

namespace lobelia::hard {

class Bench;

/// A hard case: an input, what is promised of it, and one of the three ways in which the promise is
/// accounted for.
struct Row {
    const char* id;                             // a letter for the kind and two digits
    const char* input;                          // the case, as docs/hard-cases.md names it
    const char* promise;                        // what holds
    void (*check)(Bench&, Findings&) = nullptr; // makes the input and looks
    const char* held_by = nullptr;              // Suite.Name of the test that holds it elsewhere
    const char* absent = nullptr;               // why it cannot apply
};

/// Rows of one kind under a heading.
struct Kind {
    const char* title;
    std::vector<Row> rows;
};

Kind lobe_numerics();  // A
Kind suns();           // B
Kind texel_values();   // B
Kind image_sizes();    // C
Kind exr_forms();      // C
Kind radiance_forms(); // C
Kind not_pictures();   // C
Kind hostile_files();  // D
Kind geometry();       // E
Kind views();          // F
Kind devices();        // G
Kind processes();      // H
Kind oracle_facts();   // O

/// All of them, in the order of their letters.
const std::vector<Kind>& catalogue();

} // namespace lobelia::hard
