// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/stl_file.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

namespace burin {

namespace {

// Binary form: 80 bytes of header, a count, then for each triangle 12 floats (normal, three corners) and 2 bytes.
constexpr std::size_t headerSize = 80, startOfTriangles = 84, triangleSize = 50;

Error damaged(std::string place) {
    return {ErrorCode::fileDamaged, {}, std::move(place), {}};
}

std::uint32_t statedCount(std::string_view content) {
    std::uint32_t count = 0;
    std::memcpy(&count, content.data() + headerSize, sizeof count);
    return count;
}

std::array<float, 12> triangleNumbers(std::string_view content, std::size_t triangle) {
    std::array<float, 12> numbers{};
    std::memcpy(numbers.data(), content.data() + startOfTriangles + triangle * triangleSize, sizeof numbers);
    return numbers;
}

/// Real files hold coordinates of a plausible size and a normal that is a unit vector or zero; random bytes do not.
bool looksLikeTriangle(const std::array<float, 12>& numbers) {
    constexpr float farthest = 1e7F;
    const bool near = std::all_of(numbers.begin(), numbers.end(), [](float n) { return std::abs(n) < farthest; });
    const float length = std::hypot(numbers[0], numbers[1], numbers[2]);
    return near && (length < 1e-6F || std::abs(length - 1.0F) < 0.01F);
}

/// The number of triangles that fit into the content.
std::size_t heldCount(std::string_view content) {
    return (content.size() - startOfTriangles) / triangleSize;
}

bool looksLikeBinaryStl(std::string_view content) {
    constexpr std::size_t examined = 4;
    if (content.size() < startOfTriangles + triangleSize || statedCount(content) == 0) return false;
    const std::size_t count = std::min({examined, heldCount(content), std::size_t{statedCount(content)}});
    for (std::size_t triangle = 0; triangle < count; ++triangle)
        if (!looksLikeTriangle(triangleNumbers(content, triangle))) return false;
    return true;
}

bool equalsIgnoringCase(std::string_view text, std::string_view lower) {
    return text.size() == lower.size() && std::equal(text.begin(), text.end(), lower.begin(), [](char a, char b) {
               return std::tolower(static_cast<unsigned char>(a)) == b;
           });
}

/// Words of a text with their line numbers.
class Words {
public:
    explicit Words(std::string_view text) noexcept : rest_(text) {}

    std::string_view next() noexcept {
        skipSpace();
        std::size_t length = 0;
        while (length < rest_.size() && std::isspace(static_cast<unsigned char>(rest_[length])) == 0) ++length;
        const std::string_view word = rest_.substr(0, length);
        rest_.remove_prefix(length);
        return word;
    }
    /// Returns the text after the last word on its line, without the space around it.
    std::string_view restOfLine() noexcept {
        const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
        std::string_view text = rest_.substr(0, end);
        rest_.remove_prefix(end);
        while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0) text.remove_prefix(1);
        while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.remove_suffix(1);
        return text;
    }
    bool expect(std::string_view word) noexcept { return equalsIgnoringCase(next(), word); }
    std::optional<glm::dvec3> point() {
        glm::dvec3 point(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            const std::optional<double> number = parseNumber(next());
            if (!number) return std::nullopt;
            point[axis] = *number;
        }
        return point;
    }
    std::string place() const { return "line " + std::to_string(line_); }

private:
    void skipSpace() noexcept {
        while (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_.front())) != 0) {
            if (rest_.front() == '\n') ++line_;
            rest_.remove_prefix(1);
        }
    }

    std::string_view rest_;
    std::size_t line_ = 1;
};

void addTriangle(TriangleMesh& mesh, const std::array<glm::dvec3, 3>& corners) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
}

/// Reads on after the word "facet".
bool readFacet(Words& words, TriangleMesh& mesh) {
    // The normal is computed from the corners; some programs write "nan" for that of a thin triangle.
    if (!words.expect("normal")) return false;
    for (int axis = 0; axis < 3; ++axis) words.next();
    if (!words.expect("outer") || !words.expect("loop")) return false;
    std::array<glm::dvec3, 3> corners;
    for (glm::dvec3& corner : corners) {
        if (!words.expect("vertex")) return false;
        const std::optional<glm::dvec3> point = words.point();
        if (!point) return false;
        corner = *point;
    }
    if (!words.expect("endloop") || !words.expect("endfacet")) return false;
    addTriangle(mesh, corners);
    return true;
}

/// Reads on after the word "solid" and the name. @param ended set to whether "endsolid" was found, which many writers
/// omit
Result<TriangleMesh> readFacets(Words& words, bool& ended) {
    TriangleMesh mesh;
    std::string_view word = words.next();
    for (; !word.empty() && !equalsIgnoringCase(word, "endsolid"); word = words.next())
        if (!equalsIgnoringCase(word, "facet") || !readFacet(words, mesh)) return damaged(words.place());
    ended = !word.empty();
    words.restOfLine();
    return weldIdenticalVertices(mesh);
}

} // namespace

bool hasLengthOfBinaryStl(std::string_view content) {
    return content.size() >= startOfTriangles &&
           content.size() == startOfTriangles + triangleSize * std::size_t{statedCount(content)};
}

bool isTextStl(std::string_view content) {
    Words words(content);
    if (!words.expect("solid")) return false;
    words.restOfLine();
    const std::string_view next = words.next();
    return equalsIgnoringCase(next, "facet") || equalsIgnoringCase(next, "endsolid");
}

bool isLongerBinaryStl(std::string_view content) {
    return looksLikeBinaryStl(content) && heldCount(content) >= statedCount(content);
}

std::string whereBinaryStlEnds(std::string_view content) {
    if (!looksLikeBinaryStl(content) || heldCount(content) >= statedCount(content)) return {};
    return "triangle " + std::to_string(heldCount(content) + 1) + " of " + std::to_string(statedCount(content));
}

Result<std::vector<StlSolid>> readTextStl(std::string_view content, bool& ended) {
    ended = true;
    std::vector<StlSolid> solids;
    Words words(content);
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
        if (!equalsIgnoringCase(word, "solid")) return damaged(words.place());
        const std::string name(words.restOfLine());
        Result<TriangleMesh> mesh = readFacets(words, ended);
        if (!mesh) return std::move(mesh).error();
        if (!mesh->empty()) solids.push_back({name, std::move(*mesh)});
    }
    return solids;
}

Result<std::vector<StlSolid>> readBinaryStl(std::string_view content) {
    TriangleMesh mesh;
    for (std::size_t triangle = 0; triangle < statedCount(content); ++triangle) {
        const std::array<float, 12> numbers = triangleNumbers(content, triangle);
        if (!std::all_of(numbers.begin() + 3, numbers.end(), [](float n) { return std::isfinite(n); }))
            return damaged("triangle " + std::to_string(triangle + 1));
        std::array<glm::dvec3, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = glm::dvec3(numbers[3 + 3 * i], numbers[4 + 3 * i], numbers[5 + 3 * i]);
        addTriangle(mesh, corners);
    }
    TriangleMesh welded = weldIdenticalVertices(mesh);
    if (welded.empty()) return std::vector<StlSolid>{};
    return std::vector<StlSolid>{{std::string(), std::move(welded)}};
}

} // namespace burin
