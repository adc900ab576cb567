// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/volume/runs/run_volume.h"
#include "core/volume/surface/known_faces.h"

namespace burin {

/// The shape of a stock before it is milled.
class StockShape : public KnownFaces {
public:
    /// Fills a volume with the stock. Returns false if the reserved memory is exhausted; some scanlines are then
    /// already filled.
    virtual bool fill(RunVolume& volume, PropertyIndex property) const = 0;
};

/// A box whose edges are parallel to the axes of the setup frame.
class BoxStock final : public StockShape {
public:
    /// @param box mm, setup frame
    explicit BoxStock(const Box& box) : box_(box) {}

    /// Fills the scanlines whose centre lies in the box, at least one; along them, exactly between the faces of the
    /// box.
    bool fill(RunVolume& volume, PropertyIndex property) const override;
    Number faceOf(const std::array<glm::vec3, 3>& triangle) const noexcept override;
    glm::vec3 normal(Number face, const glm::vec3& place) const noexcept override;
    glm::vec3 sharpened(const glm::vec3& point, const SharpeningRaster& raster) const noexcept override;

private:
    /// Returns the coordinate of a face along its axis. Faces 1 … 6: low and high side of x, then of y, then of z.
    float side(int face) const noexcept;

    Box box_;
};

} // namespace burin
