#pragma once

#include <string>

#include "host/descriptor.h"

namespace lobelia::host {

/// A new file in `folder` (which ends in '/', or is empty) with a name of its own,
/// `.lobelia-<process>-<number>.tmp`, gone again unless it takes another.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::string& folder);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    bool exists() const { return exists_; }
    const Descriptor& file() const { return file_; }
    bool close() { return file_.close(); }
    bool take_name(const std::string& path);

private:
    bool claim();

    std::string name_;
    Descriptor file_;
    Descriptor claim_; // holds the file's lock until it has its name
    bool exists_ = false;
};

/// Removes from `folder` the temporary files of processes that were killed. A living writer holds
/// the lock of its file, on whichever machine it runs; what cannot be locked stays.
void sweep_temporary_files(const std::string& folder);

} // namespace lobelia::host
