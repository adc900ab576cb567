// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/worker_message.h"

#include <TopoDS_Shape.hxx>

namespace burin {

/// See partEdges.
std::vector<PartEdge> edgeCurves(const TopoDS_Shape& shape, double chord);

} // namespace burin
