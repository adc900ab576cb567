// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/vendor/vendor_library.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <system_error>

namespace burin::vendor {
namespace {

namespace fs = std::filesystem;

/// Finds the file of a library in a folder: the one with its plain name, otherwise its highest version. Empty if there
/// is neither.
fs::path libraryIn(const fs::path& folder, const std::string& name) {
    std::error_code fault;
    fs::path best;
    for (fs::directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault)) {
        const std::string file = at->path().filename().string();
        if (file == name) return at->path();
        const bool version = file.starts_with(name + ".");
        if (version && (best.empty() || strverscmp(best.filename().c_str(), file.c_str()) < 0)) best = at->path();
    }
    return best;
}

/// The library folders of Debian and related systems, and of vendors' installers; the loader's cache is searched by the
/// plain name.
std::vector<fs::path> systemFolders() {
    return {"/usr/local/lib", "/usr/lib/x86_64-linux-gnu", "/usr/lib", "/usr/lib64"};
}

void* load(const std::string& file) {
    // GLOBAL: libHD searches the symbols already loaded for the libraries that it loads itself.
    return dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL | RTLD_NODELETE);
}

} // namespace

fs::path folderFrom(const char* variable) {
    const char* value = std::getenv(variable); // NOLINT(concurrency-mt-unsafe): nobody changes the environment
    return value != nullptr ? fs::path(value) : fs::path();
}

Result<VendorLibrary> VendorLibrary::open(const LibrarySearch& search) {
    std::vector<fs::path> folders = search.folders;
    std::erase(folders, fs::path());
    const std::vector<fs::path> system = systemFolders();
    folders.insert(folders.end(), system.begin(), system.end());
    std::string looked;
    for (const fs::path& folder : folders) {
        looked += (looked.empty() ? "" : ", ") + folder.string();
        const fs::path file = libraryIn(folder, search.name);
        if (file.empty()) continue;
        if (void* handle = load(file.string())) return VendorLibrary(handle, file.string(), search.package);
        const char* reason = dlerror();
        return Error{ErrorCode::deviceLibraryUnfit, file.string(), reason != nullptr ? reason : "?", search.package};
    }
    if (void* handle = load(search.name)) return VendorLibrary(handle, search.name, search.package);
    return Error{ErrorCode::deviceLibraryMissing, search.maker, search.name + " (" + search.package + ")", looked};
}

void* VendorLibrary::find(const char* name) const {
    return dlsym(handle_, name);
}

} // namespace burin::vendor
