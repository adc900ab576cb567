// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/viewport.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace burin {

/// The drawn strokes of the recording under way, so that undone strokes are also removed from the picture.
class LiveStrokes {
public:
    explicit LiveStrokes(Viewport& viewport) : viewport_(viewport) {}

    /// @param tips mm, setup frame, in order. @param begins whether they begin a new stroke
    void append(std::span<const glm::vec3> tips, bool begins);
    /// Removes the newest stroke, or restores the one removed last. Does nothing if there is none.
    void takeBack(bool undo);
    void clear();

private:
    void drawAgain();

    Viewport& viewport_;
    std::vector<std::vector<glm::vec3>> strokes_, undone_;
};

} // namespace burin
