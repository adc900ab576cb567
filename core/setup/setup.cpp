// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/setup.h"

#include "core/base/available_memory.h"
#include "core/base/numbers.h"
#include "core/geometry/frame_along.h"
#include "core/geometry/pose.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

constexpr double bytesPerMegabyte = 1e6;

Error invalid(const char* parameter, const char* allowed) {
    return {ErrorCode::stockInvalid, parameter, {}, allowed};
}

bool isLength(const glm::dvec3& v) {
    return isFinite(v) && v.x >= 0.0 && v.y >= 0.0 && v.z >= 0.0;
}

std::string megabytes(double value) {
    return formatFixed(value, 0) + " MB";
}

bool hasPart(const Model& model, const Setup& setup) {
    for (std::size_t i = 0; i < model.bodies.size(); ++i)
        if (isProtected(roleOf(setup, i))) return true;
    return false;
}

/// Returns the box around the bodies whose role `wanted` accepts.
template <class Judge>
Box boxOf(const Model& model, const Setup& setup, Judge wanted) {
    Box box;
    for (std::size_t i = 0; i < model.bodies.size(); ++i)
        if (wanted(roleOf(setup, i))) box.include(model.bodies[i].box);
    return box;
}

/// The extent of a cylinder around all embedded bodies, without margins: its ends along its axis, and its radius.
struct Reach {
    double from = std::numeric_limits<double>::infinity();
    double to = -std::numeric_limits<double>::infinity();
    double across = 0.0;
};

Reach reachAround(const Model& model, const Setup& setup, const glm::dvec3& centre) {
    const glm::dvec3& axis = setup.cylinder.axis;
    Reach reach;
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        if (!isEmbedded(roleOf(setup, i))) continue;
        for (const glm::dvec3& vertex : model.bodies[i].mesh.vertices) {
            const double along = glm::dot(vertex, axis);
            const glm::dvec3 beside = vertex - centre - glm::dot(vertex - centre, axis) * axis;
            reach.from = std::min(reach.from, along);
            reach.to = std::max(reach.to, along);
            reach.across = std::max(reach.across, glm::length(beside));
        }
    }
    return reach;
}

CylinderShape cylinderAround(const Model& model, const Setup& setup, const Box& box) {
    CylinderShape cylinder = setup.cylinder;
    const glm::dvec3 centre = box.centre();
    const Reach reach = reachAround(model, setup, centre);
    const int along = nearestAxis(cylinder.axis);
    double low = setup.marginLow[along], high = setup.marginHigh[along];
    if (cylinder.axis[along] < 0.0) std::swap(low, high);
    double side = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        if (axis != along) side = std::max({side, setup.marginLow[axis], setup.marginHigh[axis]});
    // Between its vertices, a mesh can lie behind the true surface by its chord error.
    const double chord = model.meshChord;
    cylinder.base = centre + (reach.from - chord - low - glm::dot(centre, cylinder.axis)) * cylinder.axis;
    cylinder.height = reach.to - reach.from + 2.0 * chord + low + high;
    cylinder.radius = reach.across + chord + side;
    return cylinder;
}

bool isSound(const CylinderShape& cylinder) {
    return isFinite(cylinder.base) && std::isfinite(cylinder.radius) && cylinder.radius > 0.0 &&
           std::isfinite(cylinder.height) && cylinder.height > 0.0;
}

Result<void> placeBox(const Setup& asked, const Box& bodies, Setup& setup) {
    if (!asked.stated) {
        setup.stock = {bodies.low - setup.marginLow, bodies.high + setup.marginHigh};
        return {};
    }
    const glm::dvec3 size = asked.stock.size();
    if (asked.stock.empty() || !isFinite(asked.stock.low) || !isFinite(asked.stock.high) || !(size.x > 0.0) ||
        !(size.y > 0.0) || !(size.z > 0.0))
        return invalid("stock", "a box whose second corner lies above the first along each axis");
    return {};
}

Result<void> placeCylinder(const Model& model, const Box& bodies, Setup& setup) {
    const double length = glm::length(setup.cylinder.axis);
    if (!isFinite(setup.cylinder.axis) || !(length > 0.0)) return invalid("axis", "a direction");
    setup.cylinder.axis /= length;
    if (!setup.stated) setup.cylinder = cylinderAround(model, setup, bodies);
    if (!isSound(setup.cylinder)) return invalid("cylinder", "a finite base, a radius and a height above 0 mm");
    setup.stock = boxAround(setup.cylinder);
    return {};
}

Result<void> placeForm(const Model& model, Setup& setup) {
    const Box bodies = boxOf(model, setup, isEmbedded);
    if (setup.form == StockForm::solids) {
        setup.stock = boxOf(model, setup, [](BodyRole role) { return role == BodyRole::stock; });
        if (setup.stock.empty()) return invalid("form", "solids where a body has the role stock, a box or a cylinder");
        return {};
    }
    if (setup.form == StockForm::file) {
        if (!setup.volume) return invalid("form", "a file where one was read, a box, a cylinder or solids");
        const Grid& grid = setup.volume->grid();
        if (!setup.leftBy) setup.stock = grid.box(); // otherwise its faces are known more exactly
        setup.voxel = grid.edge();
        setup.runs = grid.axis();
        setup.stockMaterial = setup.volume->materials()[setup.volume->mainMaterial()].id;
        return {};
    }
    if (!setup.stated && bodies.empty())
        return invalid("form", "a stated box or cylinder, as there is no body to lay one around");
    return setup.form == StockForm::box ? placeBox(setup, bodies, setup) : placeCylinder(model, bodies, setup);
}

} // namespace

std::string_view idOf(StockForm form) noexcept {
    switch (form) {
    case StockForm::box:
        return "box";
    case StockForm::cylinder:
        return "cylinder";
    case StockForm::solids:
        return "solids";
    case StockForm::file:
        return "file";
    }
    return "";
}

std::optional<StockForm> stockFormFromId(std::string_view id) noexcept {
    for (const StockForm form : stockForms)
        if (idOf(form) == id) return form;
    return std::nullopt;
}

glm::dvec3 topOf(const Setup& setup) noexcept {
    return placeOn(setup.stock, ProgramZero{}.sides);
}

Result<Setup> placeStock(const Model& model, Setup setup) {
    if (!(std::isfinite(setup.voxel) && setup.voxel > 0.0)) return invalid("voxel", "a finite length above 0 mm");
    if (!isLength(setup.marginLow) || !isLength(setup.marginHigh))
        return invalid("margin", "finite lengths of 0 mm or more");
    if (!setup.freeCarving && !hasPart(model, setup))
        return invalid("part", "at least one body whose role is part, or free carving");
    if (Result<void> sound = checkRegions(setup.regions); !sound) return std::move(sound).error();
    if (setup.form != StockForm::file) setup.runs = RunAxis::z;
    if (Result<void> placed = placeForm(model, setup); !placed) return std::move(placed).error();
    return placeZero(model, std::move(setup));
}

Result<Setup> placeZero(const Model& model, Setup setup) {
    const ProgramZero& zero = setup.zero;
    if (zero.on == ZeroReference::point) {
        if (!isFinite(zero.point)) return invalid("program zero", "finite coordinates");
        setup.workOffset = zero.point;
        return setup;
    }
    const Box box = zero.on == ZeroReference::stock ? setup.stock : boxOf(model, setup, isProtected);
    if (box.empty()) return invalid("program zero", "zero on the stock, as there is no part");
    setup.workOffset = placeOn(box, zero.sides);
    return setup;
}

Result<EmbeddingSize> embeddingSize(const Setup& setup) {
    if (!(std::isfinite(setup.voxel) && setup.voxel > 0.0)) return invalid("voxel", "a finite length above 0 mm");
    if (setup.stock.empty() || !isFinite(setup.stock.low) || !isFinite(setup.stock.high))
        return invalid("stock", "a finite box");
    EmbeddingSize size;
    for (int axis = 0; axis < 3; ++axis) {
        // Rounding errors of the division must not add a voxel to a stock of a whole number of voxels.
        const double voxels = std::max(1.0, std::ceil(setup.stock.size()[axis] / setup.voxel - 1e-6));
        if (voxels > Grid::maximumVoxelsPerAxis)
            return Error{ErrorCode::volumeTooLarge,
                         formatFixed(voxels, 0) + " voxels on one axis",
                         std::to_string(Grid::maximumVoxelsPerAxis) + " voxels",
                         {}};
        size.voxels[axis] = static_cast<int>(voxels);
    }
    const Result<Grid> grid = Grid::make(setup.stock.low, setup.voxel, size.voxels, setup.runs);
    if (!grid) return grid.error();
    size.megabytes = static_cast<double>(RunVolume::defaultReserve(*grid)) / bytesPerMegabyte;
    // The other half is reserved for meshes, fields, images and other programs.
    const double limit = 0.5 * static_cast<double>(availableMemory()) / bytesPerMegabyte;
    if (size.megabytes > limit)
        return Error{ErrorCode::volumeTooLarge, megabytes(size.megabytes), megabytes(limit), {}};
    return size;
}

} // namespace burin
