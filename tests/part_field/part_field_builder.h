// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/part_field/part_brick.h"

namespace burin {

/// Makes the layers of a part's field; the request must be valid. Errors: cancelled, outOfMemory. Throws
/// std::bad_alloc.
Result<std::unique_ptr<const PartFieldLayers>> buildPartField(std::shared_ptr<const MeshDistance> part,
                                                              const PartFieldRequest& request, Progress& progress);

} // namespace burin
