// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/marked_lines.h"

#include <vtkNew.h>
#include <vtkPolyDataMapper.h>

namespace burin {

MarkedLines::MarkedLines(vtkRenderer& renderer) : actor_(lineActor(vtkNew<vtkPolyData>())) {
    actor_->VisibilityOff();
    actor_->PickableOff();
    renderer.AddActor(actor_);
}

void MarkedLines::set(const PlaceChains& chains) {
    std::vector<LineEnds> lines;
    for (const std::vector<glm::dvec3>& chain : chains)
        for (std::size_t i = 1; i < chain.size(); ++i) lines.emplace_back(chain[i - 1], chain[i]);
    vtkPolyDataMapper::SafeDownCast(actor_->GetMapper())->SetInputData(lineData(lines));
    actor_->SetVisibility(!lines.empty());
}

} // namespace burin
