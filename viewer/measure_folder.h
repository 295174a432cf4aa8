#pragma once

#include <functional>

#include <lobelia/host/gpu.h>

#include "measure_cases.h"

namespace lobelia::cli {

/// The folder that measurements are kept in, where they can be gone on with.
class MeasureFolder {
public:
    /// Makes the folder where there is none. Takes over what an earlier run measured; fails where
    /// that was on another device, by another version, or on other environments of these names.
    static host::Outcome<MeasureFolder> open(const std::string& path, const host::Gpu& gpu,
                                             const std::vector<MeasureSource>& sources);

    const std::vector<MeasureRow>& rows() const { return rows_; }
    bool has(const MeasureCase& what) const;
    nlohmann::ordered_json head() const { return head_; } // all of measure.json but the rows

    /// Keeps rows: writes measure.csv and measure.json anew.
    host::Outcome<Done> add(const std::vector<MeasureRow>& rows);

    /// Replaces the file `name` in the folder.
    host::Outcome<Done> write(const std::string& name, const std::string& text) const;

    /// What `measure` gives, or gave under that key in an earlier run like this one.
    host::Outcome<host::Measured>
    remembered(const std::string& key,
               const std::function<host::Outcome<host::Measured>()>& measure) const;

private:
    std::string path_;
    nlohmann::ordered_json head_;
    std::vector<MeasureRow> rows_;

    host::Outcome<Done> load();
    host::Outcome<Done> save() const;
};

} // namespace lobelia::cli
