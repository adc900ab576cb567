// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace burin::vendor {

/// A library that the maker of a device ships, and how it is found.
struct LibrarySearch {
    std::string maker;   ///< whose devices need it: "3D Systems"
    std::string package; ///< what it comes with: "OpenHaptics 3.4 or later"
    std::string name;    ///< "libHD.so"; where that is not there, the highest version of it, "libHD.so.3.4", is taken
    std::vector<std::filesystem::path> folders; ///< looked in first, then where the system looks
};

/// Where the maker's own environment variable says that its things are; empty where it does not.
std::filesystem::path folderFrom(const char* variable);

/// A maker's library, opened at run time, so that nobody needs it to build Burin. It stays for the life of the process:
/// such libraries keep threads. A copy means the same library. Thread: any; opening may take a second.
class VendorLibrary {
public:
    /// Errors: deviceLibraryMissing, deviceLibraryUnfit (it is there and does not load).
    static Result<VendorLibrary> open(const LibrarySearch& search);

    /// Fills in a function. The types are the caller's word: a C library does not tell them. Errors: deviceLibraryUnfit
    /// (it has none of that name).
    template <class Function>
    Result<void> bind(Function*& function, const char* name) const {
        function = reinterpret_cast<Function*>(find(name)); // POSIX: dlsym gives functions as void*
        if (function == nullptr) return unfit(name);
        return {};
    }
    /// The same for one that not every version has; null then.
    template <class Function>
    void bindIfThere(Function*& function, const char* name) const {
        function = reinterpret_cast<Function*>(find(name));
    }
    /// The error that it is not what Burin needs. @param sign what shows it: a function's name, a version
    Error unfit(std::string sign) const { return {ErrorCode::deviceLibraryUnfit, file_, std::move(sign), package_}; }

private:
    VendorLibrary(void* handle, std::string file, std::string package)
        : handle_(handle), file_(std::move(file)), package_(std::move(package)) {}
    void* find(const char* name) const;

    void* handle_;
    std::string file_, package_;
};

} // namespace burin::vendor
