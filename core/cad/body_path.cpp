// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/body_path.h"

#include <algorithm>
#include <map>
#include <set>

namespace burin {

namespace {

constexpr char separator = '/';
constexpr std::string_view separatorInName = "\xE2\x81\x84"; // U+2044
constexpr int mostLevels = 32;                               // a file may nest deeper than the stack bears

/// Adds the bodies whose paths are equal up to `start`, grouped by their next element.
void addNodes(const std::vector<std::string>& paths, const std::vector<std::size_t>& bodies, std::size_t start,
              int level, std::vector<BodyNode>& nodes) {
    struct Group {
        std::size_t node, end;
        std::vector<std::size_t> bodies;
    };
    std::map<std::string_view, Group> groups;
    for (const std::size_t body : bodies) {
        const std::string_view path = paths[body];
        const std::size_t end = level < mostLevels ? path.find(separator, start) : std::string_view::npos;
        if (end == std::string_view::npos) {
            nodes.push_back({std::string(path.substr(start)), std::string(path), body});
            continue;
        }
        const std::string_view element = path.substr(start, end - start);
        const auto [group, isNew] = groups.try_emplace(element, Group{nodes.size(), end, {}});
        if (isNew) nodes.push_back({std::string(element), std::string(path.substr(0, end))});
        group->second.bodies.push_back(body);
    }
    for (const auto& [element, group] : groups)
        addNodes(paths, group.bodies, group.end + 1, level + 1, nodes[group.node].children);
}

void addBodies(const BodyNode& node, std::vector<std::size_t>& bodies) {
    if (node.body) bodies.push_back(*node.body);
    for (const BodyNode& child : node.children) addBodies(child, bodies);
}

} // namespace

std::string pathElement(std::string_view name) {
    std::string element;
    for (const char c : name)
        if (c == separator)
            element += separatorInName;
        else
            element += c;
    return element;
}

std::string bodyPath(std::string_view assembly, std::string_view name) {
    std::string path(assembly);
    if (!path.empty()) path += separator;
    return path += name;
}

std::string_view assemblyOf(std::string_view path) {
    const std::size_t last = path.rfind(separator);
    return last == std::string_view::npos ? std::string_view() : path.substr(0, last);
}

std::string_view lastElement(std::string_view path) {
    const std::size_t last = path.rfind(separator);
    return last == std::string_view::npos ? path : path.substr(last + 1);
}

std::string_view withoutInstance(std::string_view element) {
    const std::size_t colon = element.rfind(':');
    if (colon == std::string_view::npos || colon == 0 || colon + 1 == element.size()) return element;
    const std::string_view number = element.substr(colon + 1);
    const bool digits = std::ranges::all_of(number, [](char c) { return c >= '0' && c <= '9'; });
    return digits ? element.substr(0, colon) : element;
}

void numberInstances(std::vector<std::string>& names) {
    std::map<std::string, std::size_t, std::less<>> counts;
    for (const std::string& name : names) ++counts[name];
    std::set<std::string, std::less<>> taken;
    for (const auto& [name, count] : counts)
        if (count == 1) taken.insert(name);
    std::map<std::string, std::size_t, std::less<>> numbers; // the last one given
    for (std::string& name : names) {
        if (name.empty() || counts[name] == 1) continue;
        std::size_t& number = numbers[name];
        std::string numbered;
        do numbered = name + ":" + std::to_string(++number);
        while (!taken.insert(numbered).second);
        name = std::move(numbered);
    }
}

std::vector<BodyNode> bodyTree(const std::vector<std::string>& paths) {
    std::vector<std::size_t> bodies(paths.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i] = i;
    std::vector<BodyNode> nodes;
    addNodes(paths, bodies, 0, 1, nodes);
    return nodes;
}

std::vector<BodyNode> bodyTree(const Model& model) {
    std::vector<std::string> paths;
    for (const Body& body : model.bodies) paths.push_back(body.name);
    return bodyTree(paths);
}

bool hasAssemblies(const Model& model) {
    return std::ranges::any_of(model.bodies, [](const Body& body) { return !assemblyOf(body.name).empty(); });
}

std::vector<std::size_t> bodiesOf(const BodyNode& node) {
    std::vector<std::size_t> bodies;
    addBodies(node, bodies);
    return bodies;
}

std::vector<std::size_t> bodiesNamed(const Model& model, std::string_view path) {
    std::vector<std::size_t> same, within;
    const std::string inside = std::string(path) + separator;
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        if (model.bodies[i].name == path) same.push_back(i);
        if (model.bodies[i].name.starts_with(inside)) within.push_back(i);
    }
    return same.empty() ? within : same;
}

} // namespace burin
