// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace burin::vendor {

/// A library that is shipped by the vendor of a device, and how it is found.
struct LibrarySearch {
    std::string maker;   ///< vendor of the devices that need it: "3D Systems"
    std::string package; ///< package that contains it: "OpenHaptics 3.4 or later"
    std::string name;    ///< "libHD.so"; if that does not exist, its highest version, "libHD.so.3.4", is used
    std::vector<std::filesystem::path> folders; ///< searched first, then where the system searches
};

/// The installation folder given by the vendor's environment variable; empty if it is not set.
std::filesystem::path folderFrom(const char* variable);

/// A vendor's library, opened at run time, so that it is not needed to build Burin. It stays loaded until the process
/// ends, because such libraries keep threads. A copy refers to the same library. Thread-safe; opening may take a
/// second.
class VendorLibrary {
public:
    /// Errors: deviceLibraryMissing, deviceLibraryUnfit (found, but it can't be loaded).
    static Result<VendorLibrary> open(const LibrarySearch& search);

    /// Sets a pointer to a function. The caller is responsible for its type, which a C library does not state. Errors:
    /// deviceLibraryUnfit (no function with that name).
    template <class Function>
    Result<void> bind(Function*& function, const char* name) const {
        function = reinterpret_cast<Function*>(find(name)); // POSIX: dlsym returns functions as void*
        if (function == nullptr) return unfit(name);
        return {};
    }
    /// The same for a function that some versions do not have; null then.
    template <class Function>
    void bindIfThere(Function*& function, const char* name) const {
        function = reinterpret_cast<Function*>(find(name));
    }
    /// The error that the library can't be used by Burin. @param sign the reason: a function's name, a version
    Error unfit(std::string sign) const { return {ErrorCode::deviceLibraryUnfit, file_, std::move(sign), package_}; }

private:
    VendorLibrary(void* handle, std::string file, std::string package)
        : handle_(handle), file_(std::move(file)), package_(std::move(package)) {}
    void* find(const char* name) const;

    void* handle_;
    std::string file_, package_;
};

} // namespace burin::vendor
