// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <streambuf>
#include <string_view>
#include <utility>

namespace burin {

/// The text of a file as the buffer of a stream that reports how much of it was taken.
class MeasuredText final : public std::streambuf {
public:
    /// @param text outlives the object @param report called with the bytes taken so far, up to the size of the text
    MeasuredText(std::string_view text, std::function<void(std::size_t taken)> report)
        : text_(text), report_(std::move(report)) {}

protected:
    int_type underflow() override {
        if (gptr() < egptr()) return traits_type::to_int_type(*gptr());
        report_(given_);
        const std::string_view next = text_.substr(given_, chunk);
        given_ += next.size();
        if (next.empty()) return traits_type::eof();
        char* const begin = const_cast<char*>(next.data()); // NOLINT: a buffer that is only read from
        setg(begin, begin, begin + next.size());
        return traits_type::to_int_type(*begin);
    }

private:
    static constexpr std::size_t chunk = 1U << 16U; // bytes between two reports

    std::string_view text_;
    std::function<void(std::size_t)> report_;
    std::size_t given_ = 0;
};

} // namespace burin
