// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/peers/mesh_level_set.h"

#include "tests/benchmarks/peers/openvdb.h"
#include "tests/benchmarks/scenes/part_meshes.h"

#include <map>
#include <tuple>

namespace burin::benchmarks {

std::optional<double> meshLevelSetSeconds(Session& session, std::int32_t side, double triangles) {
    static std::map<std::tuple<int, std::int32_t, double>, std::optional<double>> known;
    const auto [place, isNew] = known.try_emplace({session.round(), side, triangles});
    if (isNew && hasOpenVdb()) {
        const std::string name = "OpenVDB meshToLevelSet at " + std::to_string(side);
        session.stage(name);
        place->second = session.least(name, *meshToLevelSetSeconds(bumpyPart(side, triangles), 3.0F));
    }
    return place->second;
}

} // namespace burin::benchmarks
