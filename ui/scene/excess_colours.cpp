// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/excess_colours.h"

#include "ui/scene/edge_halving.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace burin {

std::size_t ExcessMemory::Hash::operator()(const Key& key) const noexcept {
    std::uint64_t hash = 0;
    for (const std::uint32_t bits : key.bits) hash = (hash ^ bits) * 0x9E3779B97F4A7C15U;
    return static_cast<std::size_t>(hash ^ hash >> 32);
}

/// Measures distances from the part, as far as they are not in the memory.
class ExcessMeasuring {
public:
    ExcessMeasuring(const MeshDistance& part, double reach, ExcessMemory& memory)
        : part_(part), reach_(reach), memory_(memory) {
        memory_.before_ = std::move(memory_.now_);
        memory_.now_.clear();
    }
    ~ExcessMeasuring() { memory_.before_.clear(); }
    ExcessMeasuring(const ExcessMeasuring&) = delete;
    ExcessMeasuring& operator=(const ExcessMeasuring&) = delete;

    double signedDistance(const glm::vec3& point) {
        ExcessMemory::Measured& known = at(point);
        if (!std::exchange(known.measured, true)) known.signedDistance = part_.closest(point, reach_).signedDistance;
        return known.signedDistance;
    }
    bool isBeyond(const glm::vec3& point, double within) {
        ExcessMemory::Measured& known = at(point);
        if (std::exchange(known.within, within) != within)
            known.beyond = part_.closest(point, within).distance >= within;
        return known.beyond;
    }

private:
    ExcessMemory::Measured& at(const glm::vec3& point) {
        const ExcessMemory::Key key{{std::bit_cast<std::uint32_t>(point.x), std::bit_cast<std::uint32_t>(point.y),
                                     std::bit_cast<std::uint32_t>(point.z)}};
        if (const auto now = memory_.now_.find(key); now != memory_.now_.end()) return now->second;
        if (auto before = memory_.before_.extract(key)) return memory_.now_.insert(std::move(before)).position->second;
        return memory_.now_[key];
    }

    const MeshDistance& part_;
    double reach_;
    ExcessMemory& memory_;
};

namespace {

/// Computes the distance of each point of a surface from the part, and adds points where the resolution is too low.
class ExcessDivision {
public:
    ExcessDivision(SurfaceMesh& mesh, const PropertyList& properties, const ExcessColours& left,
                   const ExcessDetail& detail, ExcessMemory& memory)
        : mesh_(mesh)
        , properties_(properties)
        , scale_(left.scale())
        , reach_(std::max(scale_.marks().back().deviation, -scale_.marks().front().deviation))
        , part_(*left.part, reach_, memory)
        , cell_(detail.cell)
        , longest_(detail.longest)
        , shortest_(detail.shortest)
        , unlike_(detail.unlike / static_cast<double>(scale_.marks().size() - 1)) {
        left_.reserve(mesh.points.size());
        for (std::size_t i = 0; i < mesh.points.size(); ++i)
            left_.push_back(leftAt(mesh.points[i], mesh.properties[i]));
    }

    void divide() {
        const auto wants = [this](std::uint32_t a, std::uint32_t b) { return hides(a, b); };
        const auto addMiddle = [this](std::uint32_t a, std::uint32_t b) { return this->addMiddle(a, b); };
        while (EdgeHalving(mesh_.points, mesh_.triangles, wants, addMiddle).run()) {
        }
    }

    std::vector<DeviationColour> colours() const {
        std::vector<DeviationColour> colours;
        colours.reserve(left_.size());
        for (const double left : left_) colours.push_back(scale_.colourOf(left));
        return colours;
    }

private:
    double leftAt(const glm::vec3& point, PropertyIndex property) {
        if (properties_.isProtected(property)) return 0.0;
        const double left = part_.signedDistance(point);
        // Stock can't be inside the part: such small values are within the accuracy of the voxels.
        return left < 0.0 && left >= -cell_ ? 0.0 : left;
    }

    glm::vec3 middle(std::uint32_t a, std::uint32_t b) const { return 0.5F * (mesh_.points[a] + mesh_.points[b]); }

    /// Whether the excess along an edge differs from the interpolated value that would be drawn.
    bool hides(std::uint32_t a, std::uint32_t b) {
        const double length = glm::distance(mesh_.points[a], mesh_.points[b]);
        if (length <= shortest_ || isBeyond(a, b, length)) return false;
        if (length > longest_) return true;
        const double drawn = 0.5 * (scale_.positionOf(left_[a]) + scale_.positionOf(left_[b]));
        return std::abs(scale_.positionOf(leftAt(middle(a, b), mesh_.properties[a])) - drawn) > unlike_;
    }

    /// Whether all of an edge is beyond the scale: the distance to the part changes no faster than a point moves.
    bool isBeyond(std::uint32_t a, std::uint32_t b, double length) {
        if (std::min(left_[a], left_[b]) < reach_) return false; // distances beyond that were not measured
        return part_.isBeyond(middle(a, b), reach_ + 0.5 * length);
    }

    std::uint32_t addMiddle(std::uint32_t a, std::uint32_t b) {
        const glm::vec3 point = middle(a, b), normal = middleNormal(mesh_.normals[a], mesh_.normals[b]);
        const PropertyIndex property = mesh_.properties[a];
        mesh_.points.push_back(point);
        mesh_.normals.push_back(normal);
        mesh_.properties.push_back(property);
        left_.push_back(leftAt(point, property));
        return static_cast<std::uint32_t>(mesh_.points.size() - 1);
    }

    SurfaceMesh& mesh_;
    const PropertyList& properties_;
    DeviationScale scale_;
    double reach_; ///< mm
    ExcessMeasuring part_;
    double cell_, longest_, shortest_; ///< mm
    double unlike_;                    ///< of the scale's length
    std::vector<double> left_;         ///< mm, one per point
};

} // namespace

std::vector<DeviationColour> colourByExcess(SurfaceMesh& mesh, const PropertyList& properties,
                                            const ExcessColours& left, const ExcessDetail& detail,
                                            ExcessMemory& memory) {
    ExcessDivision division(mesh, properties, left, detail, memory);
    division.divide();
    return division.colours();
}

} // namespace burin
