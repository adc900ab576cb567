// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/measure/figures.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>

namespace burin::benchmarks {

namespace {

/// Four digits are more than a shared machine can reproduce.
std::string shortText(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", value);
    return text.data();
}

using Row = std::array<std::string, 7>;

Row rowOf(const Figure& figure) {
    Row row{figure.name, shortText(figure.value), figure.unit, "", figure.peer, "", ""};
    if (figure.limit) row[3] = (figure.atLeast ? ">= " : "<= ") + shortText(*figure.limit);
    if (figure.peerValue) row[5] = shortText(*figure.peerValue);
    if (const std::optional<double> ratio = figure.ratio()) row[6] = shortText(*ratio) + " x";
    if (figure.ratioAtLeast) row[6] += " (>= " + shortText(*figure.ratioAtLeast) + ")";
    if (figure.misses()) row[6] += row[6].empty() ? "MISSES" : "  MISSES";
    return row;
}

} // namespace

std::optional<double> Figure::ratio() const {
    if (!peerValue) return std::nullopt;
    const double better = atLeast ? value : *peerValue, worse = atLeast ? *peerValue : value;
    if (worse == 0.0) return std::nullopt;
    return better / worse;
}

bool Figure::misses() const {
    if (limit && (atLeast ? value < *limit : value > *limit)) return true;
    const std::optional<double> reached = ratio();
    return ratioAtLeast && reached && *reached < *ratioAtLeast;
}

Figure figure(std::string name, double value, std::string unit, std::optional<double> limit) {
    Figure made;
    made.name = std::move(name);
    made.value = value;
    made.unit = std::move(unit);
    made.limit = limit;
    return made;
}

Figure against(Figure own, std::string peer, double peerValue, std::optional<double> ratioAtLeast) {
    own.peer = std::move(peer);
    own.peerValue = peerValue;
    own.ratioAtLeast = ratioAtLeast;
    return own;
}

nlohmann::json jsonOf(const std::vector<Figure>& figures) {
    nlohmann::json list = nlohmann::json::array();
    for (const Figure& figure : figures) {
        nlohmann::json entry{{"name", figure.name}, {"value", figure.value}, {"unit", figure.unit}};
        if (figure.limit) entry["limit"] = *figure.limit;
        if (figure.atLeast) entry["at_least"] = true;
        if (figure.peerValue) {
            entry["peer"] = figure.peer;
            entry["peer_value"] = *figure.peerValue;
        }
        if (const std::optional<double> ratio = figure.ratio()) entry["ratio"] = *ratio;
        if (figure.ratioAtLeast) entry["ratio_at_least"] = *figure.ratioAtLeast;
        list.push_back(std::move(entry));
    }
    return list;
}

std::string tableOf(const std::vector<Figure>& figures) {
    std::vector<Row> rows{{"figure", "value", "unit", "limit", "peer", "peer's", "better by"}};
    for (const Figure& figure : figures) rows.push_back(rowOf(figure));
    std::array<std::size_t, std::tuple_size_v<Row>> width{};
    for (const Row& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], row[i].size());
    std::string text;
    for (const Row& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string gap(width[i] - row[i].size(), ' ');
            const bool number = i == 1 || i == 5;
            line += (number ? gap + row[i] : row[i] + gap) + "  ";
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text + summaryOf(figures);
}

std::string summaryOf(const std::vector<Figure>& figures) {
    std::string missed;
    std::size_t count = 0;
    for (const Figure& figure : figures) {
        if (!figure.misses()) continue;
        missed += (count++ == 0 ? ": " : ", ") + figure.name;
    }
    return std::to_string(figures.size()) + " figures, " + std::to_string(count) + " miss" +
           (count == 1 ? "es its limit" : " their limit") + missed;
}

} // namespace burin::benchmarks
