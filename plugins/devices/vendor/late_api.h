// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <chrono>
#include <optional>

namespace burin::vendor {

/// The functions of a vendor's library, loaded when they are first needed. If the library is missing, loading is tried
/// again, so that it can be installed while Burin runs, but not at each search for devices. One thread at a time.
/// @tparam Api the functions, as a plain struct
template <class Api>
class LateApi {
public:
    using Load = Result<Api> (*)();
    static constexpr std::chrono::seconds lookEvery{5};

    explicit LateApi(Load load) : load_(load) {}
    /// The functions; the pointer remains valid. Errors: those of the loading.
    Result<const Api*> get() {
        const auto now = std::chrono::steady_clock::now();
        if (!api_ && (!fault_ || now - lookedAt_ >= lookEvery)) {
            lookedAt_ = now;
            Result<Api> loaded = load_();
            if (loaded) api_ = std::move(*loaded);
            fault_ = loaded ? std::nullopt : std::optional(loaded.error());
        }
        if (!api_) return *fault_;
        return &*api_;
    }

private:
    Load load_;
    std::optional<Api> api_;
    std::optional<Error> fault_;
    std::chrono::steady_clock::time_point lookedAt_{};
};

} // namespace burin::vendor
