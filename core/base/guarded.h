// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <exception>
#include <new>
#include <utility>

namespace burin {

/// Calls `work` and returns its result, exceptions converted to errors: no exception may leave a thread.
/// @param subject name of the work, for the message
template <class Work>
auto guarded(const char* subject, Work&& work) -> decltype(work()) {
    try {
        return std::forward<Work>(work)();
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::outOfMemory, subject, {}, {}};
    } catch (const std::exception& fault) {
        return Error{ErrorCode::internalFault, subject, {}, fault.what()};
    }
}

} // namespace burin
