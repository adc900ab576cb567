// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <array>
#include <bit>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// The file form of a volume implemented literally from core/volume/packed/volume_file.md, one bit or byte after the
/// other: the writer's output and the reader's result are compared with it. Throws std::out_of_range where bytes are
/// missing.
namespace burin::oracles {

/// CRC-64/XZ, computed by its definition.
inline std::uint64_t crc64(std::string_view bytes) {
    std::uint64_t sum = ~std::uint64_t{0};
    for (const char byte : bytes) {
        sum ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) sum = (sum & 1) != 0 ? (sum >> 1) ^ 0xc96c5795d7870f42 : sum >> 1;
    }
    return ~sum;
}

/// Reads little-endian numbers from the front of bytes.
class FormBytes {
public:
    explicit FormBytes(std::string_view bytes) : bytes_(bytes) {}
    std::string_view take(std::size_t count) {
        if (count > bytes_.size() - at_) throw std::out_of_range("bytes");
        at_ += count;
        return bytes_.substr(at_ - count, count);
    }
    std::uint64_t word(std::size_t size) {
        std::uint64_t value = 0, place = 1;
        for (const char byte : take(size)) {
            value += place * static_cast<unsigned char>(byte);
            place *= 256;
        }
        return value;
    }
    std::uint32_t u32() { return static_cast<std::uint32_t>(word(4)); }
    std::uint64_t u64() { return word(8); }
    double f64() { return std::bit_cast<double>(word(8)); }
    std::size_t place() const { return at_; }
    std::string_view rest() const { return bytes_.substr(at_); }

private:
    std::string_view bytes_;
    std::size_t at_ = 0;
};

struct FormHeader {
    std::string bytes; ///< the whole record
    std::uint32_t version = 0;
    std::array<double, 3> low{};
    double edge = 0.0;
    std::array<std::uint32_t, 3> count{};
    std::uint32_t axis = 0;
    std::uint64_t segments = 0;
    std::vector<std::string> properties; ///< JSON
    bool isSound = false;                ///< mark, length and checksum are correct
};

inline FormHeader takeHeader(FormBytes& file) {
    FormHeader header;
    FormBytes record(file.rest());
    header.isSound = record.take(8) == "BurinVol";
    header.version = record.u32();
    const std::size_t length = record.u32(), begin = record.place();
    for (double& number : header.low) number = record.f64();
    header.edge = record.f64();
    for (std::uint32_t& number : header.count) number = record.u32();
    header.axis = record.u32();
    header.segments = record.u64();
    for (std::uint32_t i = record.u32(); i > 0; --i) header.properties.emplace_back(record.take(record.u32()));
    const std::size_t end = record.place();
    header.isSound = header.isSound && end == begin + length && record.u64() == crc64(file.rest().substr(0, end));
    header.bytes = file.take(record.place());
    return header;
}

struct FormBlock {
    std::uint32_t group = 0, firstBrick = 0, bricks = 0, plainBytes = 0;
    std::string frame;    ///< as stored in the file, compressed
    bool isSound = false; ///< mark and both checksums are correct
};

inline FormBlock takeBlock(FormBytes& file) {
    FormBlock block;
    const std::string_view head = file.rest().substr(0, 36);
    block.isSound = file.take(8) == "BurinBlk";
    block.group = file.u32();
    block.firstBrick = file.u32();
    block.bricks = file.u32();
    block.plainBytes = file.u32();
    const std::uint32_t length = file.u32();
    const std::uint64_t frameSum = file.u64(), headSum = file.u64();
    block.frame = file.take(length);
    block.isSound = block.isSound && headSum == crc64(head) && frameSum == crc64(block.frame);
    return block;
}

/// Reads bits from the front of bytes, lowest first.
class FormBits {
public:
    explicit FormBits(std::string_view bytes) : bytes_(bytes) {}
    std::uint32_t bit() {
        const std::size_t byte = at_ / 8;
        if (byte >= bytes_.size()) throw std::out_of_range("bits");
        return std::uint32_t{static_cast<unsigned char>(bytes_[byte])} >> (at_++ % 8) & 1;
    }
    std::uint32_t bits(unsigned count) {
        std::uint32_t value = 0;
        for (unsigned i = 0; i < count; ++i) value |= bit() << i;
        return value;
    }
    /// A number stored as Elias's gamma code of the number + 1.
    std::uint32_t number() {
        unsigned zeros = 0;
        while (bit() == 0) ++zeros;
        return (std::uint32_t{1} << zeros) + bits(zeros) - 1;
    }
    std::int32_t coefficient(unsigned width) {
        const std::uint32_t word = bits(width);
        return (word & 1) != 0 ? -static_cast<std::int32_t>(word / 2) - 1 : static_cast<std::int32_t>(word / 2);
    }
    std::size_t bytesBegun() const { return (at_ + 7) / 8; }

private:
    std::string_view bytes_;
    std::size_t at_ = 0;
};

/// Number of bits needed to distinguish so many choices.
inline unsigned choiceBits(std::size_t choices) {
    unsigned bits = 0;
    for (std::size_t most = choices - 1; most > 0; most /= 2) ++bits;
    return bits;
}

/// Reads packed bricks one after the other from a block's bytes.
class FormBricks {
public:
    using Lines = std::array<std::vector<Segment>, 64>;

    /// @param properties including air
    FormBricks(std::string_view bytes, std::uint32_t properties, RunPosition lineEnd)
        : bytes_(bytes), properties_(properties), lineEnd_(lineEnd) {}

    bool atEnd() const { return bytes_.empty(); }
    Lines next() {
        FormBits in(bytes_);
        const std::vector<PropertyIndex> palette = takePalette(in);
        const std::uint32_t groups = in.number() + 1;
        std::vector<std::vector<int>> lines(groups);
        for (int line = 0; line < 64; ++line) lines.at(groups > 1 ? in.bits(choiceBits(groups)) : 0).push_back(line);
        std::vector<std::vector<PropertyIndex>> sequences;
        for (std::uint32_t group = 0; group < groups; ++group) sequences.push_back(takeSequence(in, palette));
        Lines all;
        for (std::uint32_t group = 0; group < groups; ++group) takeEnds(in, lines[group], sequences[group], all);
        bytes_.remove_prefix(in.bytesBegun());
        return all;
    }

private:
    std::vector<PropertyIndex> takePalette(FormBits& in) const {
        std::vector<PropertyIndex> palette;
        if (properties_ <= 32) {
            for (std::uint32_t property = 0; property < properties_; ++property)
                if (in.bit() != 0) palette.push_back(static_cast<PropertyIndex>(property));
        } else {
            for (std::uint32_t left = in.number() + 1; left > 0; --left)
                palette.push_back(static_cast<PropertyIndex>(in.bits(choiceBits(properties_))));
        }
        return palette;
    }
    static std::vector<PropertyIndex> takeSequence(FormBits& in, const std::vector<PropertyIndex>& palette) {
        std::uint32_t further = in.number();
        std::size_t rank = in.bits(choiceBits(palette.size()));
        std::vector<PropertyIndex> sequence{palette.at(rank)};
        for (; further > 0; --further) {
            const std::size_t among = in.bits(choiceBits(palette.size() - 1));
            rank = among < rank ? among : among + 1; // the previous one is not counted
            sequence.push_back(palette.at(rank));
        }
        return sequence;
    }
    void takeEnds(FormBits& in, const std::vector<int>& lines, const std::vector<PropertyIndex>& sequence,
                  Lines& all) const {
        const std::size_t columns = sequence.size() - 1;
        if (columns > 0 && in.bit() != 0) {
            const unsigned width = in.bits(5);
            for (const int line : lines) {
                RunPosition end = 0;
                for (std::size_t column = 0; column < columns; ++column) {
                    end += in.bits(width) + 1;
                    at(all, line).emplace_back(end, sequence[column]);
                }
            }
        } else {
            for (std::size_t column = 0; column < columns; ++column)
                takeColumn(in, lines, column, sequence[column], all);
        }
        for (const int line : lines) at(all, line).emplace_back(lineEnd_, sequence.back());
    }
    static void takeColumn(FormBits& in, const std::vector<int>& lines, std::size_t column, PropertyIndex property,
                           Lines& all) {
        const std::uint32_t shape = in.bits(2);
        const bool isLength = column > 0 && in.bit() != 0;
        const unsigned width = in.bits(5);
        std::array<std::int64_t, 6> c{};
        if (shape == 0) {
            c[0] = std::int64_t{in.bits(in.bits(6))} * 256;
        } else {
            c[0] = in.coefficient(in.bits(6));
            const unsigned slope = in.bits(5);
            for (std::size_t i : {1U, 2U}) c[i] = in.coefficient(slope);
            const unsigned bend = shape == 2 ? in.bits(5) : 0;
            if (shape == 2)
                for (std::size_t i : {3U, 4U, 5U}) c[i] = in.coefficient(bend);
        }
        for (const int line : lines) {
            const std::int64_t u = 2 * (line % 8) - 7, v = 2 * (line / 8) - 7;
            const auto q = [](std::int64_t x) { return (x * x - 21) / 4; };
            const std::int64_t sum = c[0] + 4 * (c[1] * u + c[2] * v) + 4 * (c[3] * q(u) + c[5] * q(v)) + c[4] * u * v;
            const std::int64_t expected = sum >= 0 ? sum / 256 : -((255 - sum) / 256); // rounded down
            const auto value = static_cast<RunPosition>((expected + in.bits(width)) & 0xffffff);
            const RunPosition before = isLength ? at(all, line).back().end() : 0;
            at(all, line).emplace_back(before + value, property);
        }
    }
    static std::vector<Segment>& at(Lines& all, int line) { return all[static_cast<std::size_t>(line)]; }

    std::string_view bytes_;
    std::uint32_t properties_;
    RunPosition lineEnd_;
};

} // namespace burin::oracles
