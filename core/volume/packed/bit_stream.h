// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace burin {

/// Appends numbers of any bit width to a byte string, lowest bit first.
class BitWriter {
public:
    /// @param bytes  appended to; has to outlive this object
    explicit BitWriter(std::string& bytes) noexcept : bytes_(bytes) {}

    /// @param value below 2^width
    /// @param width 0 … 32
    void put(std::uint32_t value, unsigned width) {
        waiting_ |= std::uint64_t{value} << count_;
        count_ += width;
        if (count_ < 32) return;
        append(4);
    }
    /// Writes any number below 2^32 - 1, small ones in few bits (Elias's gamma code of value + 1).
    void putNumber(std::uint32_t value) {
        const unsigned further = bitsOfNumber(value) / 2;
        put(0, further);
        put(1, 1);
        put((value + 1) ^ (std::uint32_t{1} << further), further);
    }
    static unsigned bitsOfNumber(std::uint32_t value) noexcept {
        return 2 * static_cast<unsigned>(std::bit_width(value + 1)) - 1;
    }
    /// Pads the last byte with zeros and writes the pending bits.
    void finish() {
        append((count_ + 7) / 8);
        count_ = 0;
    }

private:
    void append(unsigned bytes) {
        char ready[8];
        for (unsigned i = 0; i < bytes; ++i, waiting_ >>= 8) ready[i] = static_cast<char>(waiting_ & 0xff);
        bytes_.append(ready, bytes);
        count_ -= 8 * bytes;
    }

    std::string& bytes_;
    std::uint64_t waiting_ = 0;
    unsigned count_ = 0; ///< pending bits, below 32 between calls
};

/// Reads what a BitWriter wrote. Beyond the end it returns zeros, and `good` becomes false.
class BitReader {
public:
    explicit BitReader(std::string_view bytes) noexcept : bytes_(bytes) {}

    /// @param width 0 … 32
    std::uint32_t get(unsigned width) noexcept {
        const std::uint64_t word = ahead();
        at_ += width;
        return static_cast<std::uint32_t>(word & ((std::uint64_t{1} << width) - 1));
    }
    std::uint32_t getNumber() noexcept {
        const std::uint64_t word = ahead();
        const auto further = static_cast<unsigned>(std::countr_zero(word | std::uint64_t{1} << 32));
        if (further > 31) at_ = bytes_.size() * 8 + 1; // no valid number
        at_ += further + 1;
        return (get(further) | std::uint32_t{1} << (further & 31)) - 1;
    }
    /// Whether at least this many bits are left to read.
    bool holds(std::uint64_t bits) const noexcept {
        const std::uint64_t all = std::uint64_t{bytes_.size()} * 8;
        return at_ <= all && bits <= all - at_;
    }
    /// False if more was read than there is.
    bool good() const noexcept { return at_ <= std::uint64_t{bytes_.size()} * 8; }
    /// Number of bytes read, including a partly read last one.
    std::size_t bytesRead() const noexcept { return static_cast<std::size_t>((at_ + 7) / 8); }

private:
    /// The next 57 bits or more, with zeros beyond the end.
    std::uint64_t ahead() const noexcept {
        const auto byte = static_cast<std::size_t>(at_ / 8);
        std::uint64_t word = 0;
        if (std::endian::native == std::endian::little && byte + sizeof word <= bytes_.size())
            std::memcpy(&word, bytes_.data() + byte, sizeof word);
        else
            for (std::size_t i = byte; i < std::min(byte + sizeof word, bytes_.size()); ++i)
                word |= octet(i) << (8 * (i - byte));
        return word >> (at_ % 8);
    }
    std::uint64_t octet(std::size_t place) const noexcept { return static_cast<unsigned char>(bytes_[place]); }

    std::string_view bytes_;
    std::uint64_t at_ = 0; ///< position in bits
};

} // namespace burin
