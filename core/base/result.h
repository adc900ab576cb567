// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/error.h"

#include <cassert>
#include <optional>
#include <utility>
#include <variant>

namespace burin {

/// A value, or an Error in its place. Access to the wrong one is a programming error (asserted).
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}     // NOLINT: implicit on purpose
    Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {} // NOLINT: implicit on purpose

    explicit operator bool() const noexcept { return content_.index() == 0; }
    bool hasValue() const noexcept { return content_.index() == 0; }

    T& value() & {
        assert(hasValue());
        return *std::get_if<0>(&content_);
    }
    const T& value() const& {
        assert(hasValue());
        return *std::get_if<0>(&content_);
    }
    T&& value() && {
        assert(hasValue());
        return std::move(*std::get_if<0>(&content_));
    }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

    const Error& error() const& {
        assert(!hasValue());
        return *std::get_if<1>(&content_);
    }
    Error&& error() && {
        assert(!hasValue());
        return std::move(*std::get_if<1>(&content_));
    }

private:
    std::variant<T, Error> content_;
};

/// Success without a value, or an Error.
template <>
class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : error_(std::move(error)) {} // NOLINT: implicit on purpose

    explicit operator bool() const noexcept { return !error_; }
    bool hasValue() const noexcept { return !error_; }
    const Error& error() const& {
        assert(error_);
        return *error_;
    }
    Error&& error() && {
        assert(error_);
        return std::move(*error_);
    }

private:
    std::optional<Error> error_;
};

} // namespace burin
