// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "ui/scene/actors.h"
#include "ui/theme/theme.h"

#include <vtkRenderer.h>

namespace burin {

/// The soft shadow on the table around the content: it shows where the workpiece ends and the ground begins. Visible
/// only from above.
class GroundShadow {
public:
    explicit GroundShadow(vtkRenderer& renderer);
    void setPalette(const Palette& palette);
    /// @param content bounding box of what is on the table, mm; empty: no shadow
    void setContent(const Box& content);

private:
    void refresh();

    vtkSmartPointer<vtkActor> actor_;
    QColor colour_;
    Box content_;
};

} // namespace burin
