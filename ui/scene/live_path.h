// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/path_thinner.h"

#include <vtkRenderer.h>

#include <QColor>

#include <glm/glm.hpp>

#include <memory>
#include <span>
#include <vector>

namespace burin {

/// The path as it is being recorded. Points are added to a small block that is uploaded to the driver with each
/// addition; full blocks are merged in pairs, so that an hour of milling needs only some dozen actors, and the cost of
/// a point doesn't depend on the length of the path.
class LivePath {
public:
    static constexpr std::size_t blockLines = 1024, largestBlock = 65'536;
    static constexpr float tolerance = 0.01F; ///< mm, maximum deviation of the drawn path due to thinning

    explicit LivePath(vtkRenderer& renderer);
    ~LivePath();
    void setColours(const QColor& line, const QColor& halo);
    void setLineWidth(double screenPixels);
    void append(std::span<const glm::vec3> tips, bool newStroke);
    void clear();

private:
    struct Block;
    void addLine(const glm::vec3& from, const glm::vec3& to);
    void closeBlock();
    std::unique_ptr<Block> makeBlock(std::size_t capacity);

    vtkRenderer& renderer_;
    QColor colour_, halo_;
    double width_ = 1.0;
    std::vector<std::unique_ptr<Block>> closed_;
    std::unique_ptr<Block> open_;
    PathThinner thinner_{tolerance};
    glm::vec3 end_{0.0F};
    bool hasEnd_ = false, endHasLine_ = false;
};

} // namespace burin
