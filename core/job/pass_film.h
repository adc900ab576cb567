// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/passes/pass_ground.h"
#include "core/passes/pass_request.h"

#include <optional>
#include <vector>

namespace burin {

/// Shows how a pass comes from a stroke: the stroke that leads it, the directions in which the tool will mill, then the
/// rows one after the other in milling order. mm, setup frame; s. An object only computes its pictures.
class PassFilm {
public:
    static constexpr double leadSeconds = 2.5, directionSeconds = 1.5, rowSeconds = 6.0;

    struct Picture {
        std::vector<TipLine> lines;    ///< drawn so far; of the rows those that are milled
        std::optional<glm::dvec3> tip; ///< of the tool; empty: it is not shown
        std::size_t rows = 0;          ///< number of rows that are complete
    };

    /// @param leads lines of the request; empty: the film begins with the directions @param rows of a preview
    PassFilm(std::vector<TipLine> leads, std::vector<TipLine> rows);

    double duration() const noexcept { return (leads_.empty() ? 0.0 : leadSeconds) + directionSeconds + rowSeconds; }
    /// @param seconds from the beginning; after the end everything is milled
    Picture at(double seconds) const;

private:
    std::vector<TipLine> leads_, rows_, directions_;
};

/// Short arrows along lines in the direction in which they are milled. @param apart from one arrow to the next, mm
std::vector<TipLine> directionArrows(const std::vector<TipLine>& lines, double apart);

/// The request with a sample stroke or area across the part where its kind needs one and it has none, so that its film
/// can be shown. @param part its bounding box, mm, setup frame
PassRequest withSample(PassRequest request, const Box& part);

} // namespace burin
