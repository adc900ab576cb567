// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/body_rows.h"

#include "ui/panels/model_labels.h"
#include "ui/panels/role_labels.h"
#include "ui/theme/colour.h"

#include <QCoreApplication>

#include <algorithm>

namespace burin {

namespace {

struct BodyRows {
    Q_DECLARE_TR_FUNCTIONS(BodyRows)
};

constexpr std::size_t mostOpen = 20; // bodies in an assembly whose row is open at first
constexpr qint64 levels = 64;        // more than a tree has

/// Unique among assemblies, and the same as long as the bodies are: by its first body and its level, from 0.
qint64 rowIdOf(const BodyNode& node, qint64 level) {
    return static_cast<qint64>(bodiesOf(node).front()) * levels + level;
}

ProjectRow rowOfBody(const ShownBodies& shown, const BodyNode& node) {
    const std::size_t body = *node.body;
    const BodyRole role = roleOf(shown.setup, body);
    ProjectRow row{ProjectRowKind::body, static_cast<qint64>(body), bodyName(node.name), roleText(role),
                   BodyRows::tr("Tick: shown in the view.")};
    row.on = !shown.hidden.contains(body);
    row.dimmed = role == BodyRole::ignored;
    if (body < shown.colours.size()) row.swatch = colourFrom(shown.colours[body]);
    return row;
}

std::vector<ProjectRow> rowsOf(const ShownBodies& shown, const std::vector<BodyNode>& nodes, qint64 level);

ProjectRow rowOfAssembly(const ShownBodies& shown, const BodyNode& node, qint64 level) {
    const std::vector<std::size_t> bodies = bodiesOf(node);
    const std::size_t first = bodies.front();
    const auto roleOfBody = [&](std::size_t body) { return roleOf(shown.setup, body); };
    const auto isHidden = [&](std::size_t body) { return shown.hidden.contains(body); };
    const auto colourOf = [&](std::size_t body) {
        return body < shown.colours.size() ? shown.colours[body] : BodyColour();
    };
    const auto isAlike = [&](const auto& value) {
        return std::ranges::all_of(bodies, [&](std::size_t body) { return value(body) == value(first); });
    };
    ProjectRow row{ProjectRowKind::assembly, rowIdOf(node, level), bodyName(node.name),
                   isAlike(roleOfBody) ? roleText(roleOfBody(first)) : BodyRows::tr("several roles"),
                   bodies.size() == 1
                       ? BodyRows::tr("1 body. Tick: shown in the view.")
                       : BodyRows::tr("%n bodies. Tick: shown in the view.", nullptr, static_cast<int>(bodies.size()))};
    row.on = std::ranges::none_of(bodies, isHidden);
    row.partly = !*row.on && !std::ranges::all_of(bodies, isHidden);
    row.dimmed = std::ranges::all_of(bodies, [&](std::size_t body) { return roleOfBody(body) == BodyRole::ignored; });
    row.folded = bodies.size() > mostOpen;
    if (isAlike(colourOf)) row.swatch = colourFrom(colourOf(first));
    row.children = rowsOf(shown, node.children, level + 1);
    return row;
}

std::vector<ProjectRow> rowsOf(const ShownBodies& shown, const std::vector<BodyNode>& nodes, qint64 level) {
    std::vector<ProjectRow> rows;
    for (const BodyNode& node : nodes)
        rows.push_back(node.body ? rowOfBody(shown, node) : rowOfAssembly(shown, node, level));
    return rows;
}

const BodyNode* nodeWithId(const std::vector<BodyNode>& nodes, qint64 id, qint64 level) {
    for (const BodyNode& node : nodes) {
        if (node.body) continue;
        if (rowIdOf(node, level) == id) return &node;
        if (const BodyNode* below = nodeWithId(node.children, id, level + 1)) return below;
    }
    return nullptr;
}

} // namespace

std::vector<ProjectRow> rowsOfBodies(const ShownBodies& shown) {
    return rowsOf(shown, bodyTree(shown.model), 0);
}

const BodyNode* assemblyOfRow(const std::vector<BodyNode>& tree, qint64 id) {
    return nodeWithId(tree, id, 0);
}

} // namespace burin
