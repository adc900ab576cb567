// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/ply_head.h"

#include "core/base/numbers.h"
#include "core/cad/reader/text_lines.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

namespace burin {

namespace {

struct Property {
    std::size_t size = 0;      ///< bytes of one value
    std::size_t countSize = 0; ///< bytes of a list's length; 0: not a list
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

enum class Order { text, little, big };

struct Head {
    Order order = Order::text;
    std::vector<Element> elements;
    std::string_view body; ///< the content after the header
};

std::size_t sizeOf(std::string_view type) {
    struct Type {
        std::string_view name;
        std::size_t size;
    };
    constexpr std::array types{Type{"char", 1},  Type{"uchar", 1},   Type{"int8", 1},   Type{"uint8", 1},
                               Type{"short", 2}, Type{"ushort", 2},  Type{"int16", 2},  Type{"uint16", 2},
                               Type{"int", 4},   Type{"uint", 4},    Type{"int32", 4},  Type{"uint32", 4},
                               Type{"float", 4}, Type{"float32", 4}, Type{"double", 8}, Type{"float64", 8}};
    const auto found = std::ranges::find(types, type, &Type::name);
    return found == types.end() ? 0 : found->size;
}

/// Empty if it is not a property.
std::optional<Property> propertyOf(std::string_view rest) {
    const auto [type, behind] = firstWord(rest);
    if (type != "list") return sizeOf(type) > 0 ? std::optional(Property{sizeOf(type), 0}) : std::nullopt;
    const auto [count, values] = firstWord(behind);
    const Property list{sizeOf(firstWord(values).first), sizeOf(count)};
    if (list.size == 0 || list.countSize == 0 || list.countSize > 4) return std::nullopt;
    return list;
}

bool take(std::string_view line, Head& head) {
    const auto [word, rest] = firstWord(line);
    const auto [name, behind] = firstWord(rest);
    if (word == "format" && name != "ascii") head.order = name == "binary_big_endian" ? Order::big : Order::little;
    if (word == "element") {
        const std::optional<double> count = parseNumber(firstWord(behind).first);
        if (!count || *count < 0.0 || *count > 1e12) return false;
        head.elements.push_back({std::string(name), static_cast<std::uint64_t>(*count), {}});
    }
    if (word == "property") {
        const std::optional<Property> property = propertyOf(rest);
        if (!property || head.elements.empty()) return false;
        head.elements.back().properties.push_back(*property);
    }
    return true;
}

std::optional<Head> headOf(std::string_view content) {
    Head head;
    TextLines lines(content);
    while (const auto line = lines.next()) {
        if (trimmed(*line) == "end_header") {
            head.body = lines.rest();
            return head;
        }
        if (!take(*line, head)) return std::nullopt;
    }
    return std::nullopt;
}

std::uint64_t lengthAt(std::string_view body, std::size_t at, std::size_t size, Order order) {
    std::uint64_t length = 0;
    for (std::size_t i = 0; i < size; ++i) {
        const std::size_t byte = order == Order::big ? size - 1 - i : i;
        length |= static_cast<std::uint64_t>(static_cast<unsigned char>(body[at + byte])) << (8 * i);
    }
    return length;
}

/// Skips one row of an element. Returns false if the content ends within it.
bool step(const Element& element, const Head& head, std::size_t& at) {
    for (const Property& property : element.properties) {
        std::uint64_t values = 1;
        if (property.countSize > 0) {
            if (head.body.size() - at < property.countSize) return false;
            values = lengthAt(head.body, at, property.countSize, head.order);
            at += property.countSize;
        }
        if ((head.body.size() - at) / property.size < values) return false;
        at += values * property.size;
    }
    return true;
}

std::string cutOff(const Element& element, std::uint64_t row) {
    return std::to_string(row) + " of " + std::to_string(element.count) + " rows of \"" + element.name + "\"";
}

std::string missingBytes(const Head& head) {
    std::size_t at = 0;
    for (const Element& element : head.elements) {
        if (element.properties.empty()) continue;
        for (std::uint64_t row = 0; row < element.count; ++row)
            if (!step(element, head, at)) return cutOff(element, row);
    }
    return {};
}

std::string missingLines(const Head& head) {
    TextLines lines(head.body);
    for (const Element& element : head.elements)
        for (std::uint64_t row = 0; row < element.count; ++row) {
            auto line = lines.next();
            while (line && trimmed(*line).empty()) line = lines.next();
            if (!line) return cutOff(element, row);
        }
    return {};
}

} // namespace

std::string missingOfPly(std::string_view content) {
    const std::optional<Head> head = headOf(content);
    if (!head) return "a head that can be read";
    return head->order == Order::text ? missingLines(*head) : missingBytes(*head);
}

} // namespace burin
