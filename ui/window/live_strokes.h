// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/viewport.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace burin {

/// The strokes of the recording under way as they are drawn, so that one that is taken back goes from the picture too.
class LiveStrokes {
public:
    explicit LiveStrokes(Viewport& viewport) : viewport_(viewport) {}

    /// @param tips mm, setup frame, in order. @param begins whether they begin another stroke
    void append(std::span<const glm::vec3> tips, bool begins);
    /// The newest stroke goes, or the one that went last comes again. Nothing happens when it is none of these.
    void takeBack(bool undo);
    void clear();

private:
    void drawAgain();

    Viewport& viewport_;
    std::vector<std::vector<glm::vec3>> strokes_, undone_;
};

} // namespace burin
