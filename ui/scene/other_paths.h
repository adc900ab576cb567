// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/evaluate.h"
#include "ui/scene/actors.h"

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <vector>

namespace burin {

/// What the job mills with other tools than the one in force: where they cut and plunge, thin and grey, without their
/// rapids.
class OtherPaths {
public:
    explicit OtherPaths(vtkRenderer& renderer);
    void setColour(const QColor& colour) { burin::setColour(*actor_, colour); }
    void setLineWidth(double screenPixels) { burin::setLineWidth(*actor_, screenPixels); }
    void setPaths(const std::vector<std::shared_ptr<const EvaluatedPath>>& paths);
    void setVisible(bool visible);

private:
    vtkSmartPointer<vtkActor> actor_;
    bool visible_ = true, empty_ = true;
};

} // namespace burin
