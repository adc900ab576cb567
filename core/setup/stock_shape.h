// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/volume/runs/run_volume.h"
#include "core/volume/surface/known_faces.h"

namespace burin {

/// What a stock looks like before it is milled.
class StockShape : public KnownFaces {
public:
    /// Fills a volume with the stock. False: out of reserved memory; some scanlines are filled already.
    virtual bool fill(RunVolume& volume, PropertyIndex property) const = 0;
};

/// A box, its edges along the axes of the setup frame.
class BoxStock final : public StockShape {
public:
    /// @param box mm, setup frame
    explicit BoxStock(const Box& box) : box_(box) {}

    /// Scanlines whose centre lies in the box, one at least; along them its own faces.
    bool fill(RunVolume& volume, PropertyIndex property) const override;
    Number faceOf(const std::array<glm::vec3, 3>& triangle) const noexcept override;
    glm::vec3 normal(Number face, const glm::vec3& place) const noexcept override;
    glm::vec3 sharpened(const glm::vec3& point, const SharpeningRaster& raster) const noexcept override;

private:
    /// Of face 1 … 6, low and high side of x, then of y, then of z: along its axis.
    float side(int face) const noexcept;

    Box box_;
};

} // namespace burin
