// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/model.h"

namespace burin {

Box Model::box() const {
    Box whole;
    for (const Body& body : bodies) whole.include(body.box);
    return whole;
}

double Model::volume() const {
    double sum = 0.0;
    for (const Body& body : bodies) sum += body.volume;
    return sum;
}

} // namespace burin
