// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/geometry/mesh_distance.h"
#include "core/passes/pass_request.h"
#include "core/path/path.h"
#include "core/tool/tool.h"

#include <span>
#include <unordered_map>
#include <vector>

namespace burin {

/// What is left standing where a pass was to come to the part.
struct StockLeft {
    double reachable = 0.0; ///< mm² of the part that the pass was asked for, and its tool reaches from above
    double within99 = 0.0;  ///< mm: on 99 % of that no more is left
    double most = 0.0;      ///< mm
};

/// Measures how far a part's surface is from what the flutes of upright cutters sweep, by 20,000 places that lie evenly
/// on what of it looks upwards. Never too little; tips are looked at 0.1 mm apart, which makes it too much by 0.0004 mm
/// at a radius of 3 mm, and the less the larger that is. One thread at a time.
class StockLeftMeter {
public:
    /// Keeps a reference to the part. @param part, stock in the setup frame: nothing stands outside of the box
    StockLeftMeter(const MeshDistance& part, const Box& stock);

    /// The flutes go along a path. @param from index of the first point that they go to, > 0 @param to of the last
    /// Rapids count for nothing. Cost: the length of the moves. Cancelled, it has swept a part of them.
    void sweep(std::span<const PathPoint> points, std::size_t from, std::size_t to, const Tool& tool,
               const Progress& progress);

    /// Of all that was swept until now, where a pass was asked for. @param tool of the pass
    StockLeft leftBy(const PassRequest& request, const Tool& tool, const Progress& progress) const;

private:
    struct Place {
        glm::dvec3 point{0.0}, normal{0.0}; ///< mm; unit, out of the part
        double left = 0.0;                  ///< mm, until now
    };
    void sweepTo(const glm::dvec3& tip, std::span<const RevolvedPiece> flutes, double widest);
    static std::int64_t squareOf(std::int64_t column, std::int64_t row) noexcept {
        return column * 0x100000000LL + (row & 0xffffffffLL);
    }

    const MeshDistance& part_;
    double areaOfPlace_ = 0.0; ///< mm² that each place stands for
    std::vector<Place> places_;
    std::unordered_map<std::int64_t, std::vector<std::uint32_t>> squares_; ///< of a millimetre, in plan
};

} // namespace burin
