// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace burin {

/// Appends values to a string of bytes in the byte order of this machine; writer and reader run on the same machine.
class ByteWriter {
public:
    template <class T>
    void value(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); // NOLINT: bytes of a plain value
    }
    void text(std::string_view text) {
        value(static_cast<std::uint64_t>(text.size()));
        bytes_.append(text);
    }
    template <class T>
    void list(const std::vector<T>& values) {
        static_assert(std::is_trivially_copyable_v<T>);
        value(static_cast<std::uint64_t>(values.size()));
        if (!values.empty())
            bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)); // NOLINT
    }
    std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
};

/// Reads back what ByteWriter wrote, from untrusted bytes: whatever does not fit makes `good` false and reads as zero
/// or empty from then on. Never allocates more than the bytes hold.
class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) noexcept : rest_(bytes) {}

    template <class T>
    T value() noexcept {
        static_assert(std::is_trivially_copyable_v<T>);
        T value{};
        if (const char* source = bytes(sizeof value)) std::memcpy(&value, source, sizeof value);
        return value;
    }
    std::string text() {
        const auto size = value<std::uint64_t>();
        const char* source = bytes(size);
        return source ? std::string(source, size) : std::string();
    }
    template <class T>
    std::vector<T> list() {
        static_assert(std::is_trivially_copyable_v<T>);
        const auto count = value<std::uint64_t>();
        if (count > rest_.size() / sizeof(T)) good_ = false;
        std::vector<T> values(good_ ? count : 0);
        if (const char* source = bytes(values.size() * sizeof(T)); source && !values.empty())
            std::memcpy(values.data(), source, values.size() * sizeof(T));
        return values;
    }
    /// Reads the number of items of at least `leastSize` bytes each that follow. If that many can't follow, returns 0
    /// and makes `good` false.
    std::uint64_t count(std::size_t leastSize) noexcept {
        const auto count = value<std::uint64_t>();
        if (count > rest_.size() / leastSize) good_ = false;
        return good_ ? count : 0;
    }
    bool good() const noexcept { return good_; }
    /// Whether everything fitted and no bytes are left over.
    bool finished() const noexcept { return good_ && rest_.empty(); }

private:
    const char* bytes(std::uint64_t size) noexcept {
        if (!good_ || size > rest_.size()) {
            good_ = false;
            return nullptr;
        }
        const char* start = rest_.data();
        rest_.remove_prefix(size);
        return start;
    }

    std::string_view rest_;
    bool good_ = true;
};

} // namespace burin
