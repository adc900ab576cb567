// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/external_files.h"

#include "core/base/clean_text.h"

#include <STEPConstruct_ExternRefs.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <system_error>
#include <vector>

namespace burin {

namespace fs = std::filesystem;

namespace {

class Walk {
public:
    explicit Walk(fs::path folder) : folder_(std::move(folder)) {}

    void visit(const STEPControl_Reader& reader, const std::string& name) {
        above_.push_back(name);
        STEPConstruct_ExternRefs references(reader.WS());
        references.LoadExternRefs();
        for (int i = 1; i <= references.NbExternRefs(); ++i)
            if (const char* other = references.FileName(i); other != nullptr && *other != '\0') follow(other);
        above_.pop_back();
    }

    ExternalFiles take() { return std::move(found_); }

private:
    void follow(const std::string& name) {
        if (name.find_first_of("/\\") != std::string::npos || name == "..") {
            found_.outside.insert(cleanLine(name));
            return;
        }
        if (std::find(above_.begin(), above_.end(), name) != above_.end()) {
            found_.circular = true;
            return;
        }
        if (!seen_.insert(name).second) return;
        const fs::path file = folder_ / name;
        std::error_code ignored;
        STEPControl_Reader reader;
        if (!fs::is_regular_file(file, ignored))
            found_.missing.insert(cleanLine(name));
        else if (reader.ReadFile(file.c_str()) == IFSelect_RetDone)
            visit(reader, name);
    }

    fs::path folder_;
    std::vector<std::string> above_; // names from the first file to the current one
    std::set<std::string> seen_;
    ExternalFiles found_;
};

} // namespace

ExternalFiles externalFilesOf(const STEPControl_Reader& reader, const fs::path& file) {
    Walk walk(file.parent_path());
    walk.visit(reader, file.filename().string());
    return walk.take();
}

std::string joined(const std::set<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    return list;
}

} // namespace burin
