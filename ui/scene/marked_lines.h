// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/actors.h"
#include "ui/scene/place_chains.h"

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace burin {

/// Lines over everything else: what is chosen or looked at, what the user draws. A chain of one place is a dot.
class MarkedLines {
public:
    explicit MarkedLines(vtkRenderer& renderer);
    void setColour(const QColor& colour) { burin::setColour(*actor_, colour); }
    void setLineWidth(double screenPixels);
    void set(const PlaceChains& chains);
    bool visible() const { return actor_->GetVisibility() != 0; }

private:
    vtkSmartPointer<vtkActor> actor_;
};

} // namespace burin
