// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/assembly_report.h"

#include "app/wording.h"
#include "core/base/numbers.h"
#include "ui/panels/model_labels.h"

namespace burin {

namespace {

using BodyText = std::function<std::string(std::size_t body, const std::string& name)>;

double volumeOf(const Model& model, const std::vector<std::size_t>& bodies) {
    double sum = 0.0;
    for (const std::size_t body : bodies) sum += model.bodies[body].volume;
    return sum;
}

nlohmann::json jsonOfNodes(const Model& model, const std::vector<BodyNode>& nodes) {
    nlohmann::json list = nlohmann::json::array();
    for (const BodyNode& node : nodes) {
        if (node.body) continue;
        const std::vector<std::size_t> bodies = bodiesOf(node);
        list.push_back({{"name", node.name},
                        {"path", node.path},
                        {"bodies", bodies.size()},
                        {"volume_mm3", volumeOf(model, bodies)},
                        {"assemblies", jsonOfNodes(model, node.children)}});
    }
    return list;
}

std::string assemblyText(const Model& model, const BodyNode& node) {
    const std::vector<std::size_t> bodies = bodiesOf(node);
    return worded(bodies.size(), BURIN_TEXT("Command", "assembly %2: %1 body, %3 mm^3"),
                  BURIN_TEXT("Command", "assembly %2: %1 bodies, %3 mm^3"),
                  {bodyName(node.name).toStdString(), formatFixed(volumeOf(model, bodies), 3)});
}

void addTreeLines(const Model& model, const std::vector<BodyNode>& nodes, const std::string& indent,
                  const BodyText& bodyText, std::string& text) {
    for (const BodyNode& node : nodes) {
        text += "\n" + indent;
        text += node.body ? bodyText(*node.body, bodyName(node.name).toStdString()) : assemblyText(model, node);
        addTreeLines(model, node.children, indent + "  ", bodyText, text);
    }
}

} // namespace

nlohmann::json jsonOfAssemblies(const Model& model) {
    return jsonOfNodes(model, bodyTree(model));
}

std::string textOfTree(const Model& model, const BodyText& bodyText) {
    std::string text;
    addTreeLines(model, bodyTree(model), "  ", bodyText, text);
    return text;
}

std::string textOfRoles(const Model& model, const Setup& setup) {
    if (!hasAssemblies(model)) return {};
    return textOfTree(model, [&](std::size_t body, const std::string& name) {
        return worded(BURIN_TEXT("Command", "body     %1: %2"), {name, std::string(idOf(roleOf(setup, body)))});
    });
}

} // namespace burin
