#include "environment_list.h"

#include <algorithm>
#include <filesystem>

namespace lobelia::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* INSTALLED = "/usr/share/blender/datafiles/studiolights/world";
constexpr std::size_t MOST = 60; // of a folder: a list that a person can read

std::vector<std::string> files_in(const fs::path& folder) {
    std::vector<std::string> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string ending = entry->path().extension().string();
        std::error_code ignored;
        if ((ending == ".exr" || ending == ".hdr") && entry->is_regular_file(ignored))
            files.push_back(entry->path().string());
    }
    std::sort(files.begin(), files.end());
    if (files.size() > MOST) files.resize(MOST);
    return files;
}

} // namespace

std::vector<std::string> list_environment_files(const std::string& current) {
    std::vector<std::string> all{""};
    const auto add = [&](const std::vector<std::string>& files) {
        for (const std::string& file : files)
            if (std::find(all.begin(), all.end(), file) == all.end()) all.push_back(file);
    };
    add(files_in(INSTALLED));
    if (!current.empty()) {
        add({current});
        const fs::path folder = fs::path(current).parent_path();
        add(files_in(folder.empty() ? "." : folder));
    }
    return all;
}

} // namespace lobelia::cli
