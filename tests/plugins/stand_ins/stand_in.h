// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dlfcn.h>

#include <cstdlib>

namespace burin::testing {

/// Access of a test to the state of a library that stands in for a vendor's. The test is not linked with it: otherwise
/// a driver that looks for the vendor's library by name would find it in the process.
/// @param file  that the driver is directed to @param entry  function that returns a State*
template <class State>
State& standInOf(const char* file, const char* entry) {
    void* library = dlopen(file, RTLD_NOW | RTLD_GLOBAL | RTLD_NODELETE);
    void* found = library != nullptr ? dlsym(library, entry) : nullptr;
    if (found == nullptr) std::abort(); // error in the test's own set-up
    return *reinterpret_cast<State* (*)()>(found)();
}

} // namespace burin::testing
