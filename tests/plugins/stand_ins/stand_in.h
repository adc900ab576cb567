// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dlfcn.h>

#include <cstdlib>

namespace burin::testing {

/// What a library that stands in for a maker's lets a test see. The test is not linked with it: a driver that looks for
/// the maker's by its name would find it in the process then.
/// @param file that the driver is led to @param entry that gives a State*
template <class State>
State& standInOf(const char* file, const char* entry) {
    void* library = dlopen(file, RTLD_NOW | RTLD_GLOBAL | RTLD_NODELETE);
    void* found = library != nullptr ? dlsym(library, entry) : nullptr;
    if (found == nullptr) std::abort(); // the test's own set-up
    return *reinterpret_cast<State* (*)()>(found)();
}

} // namespace burin::testing
