// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace burin::benchmarks {

/// One measured number, with its limit and the peer that it is compared with.
struct Figure {
    std::string name; ///< "cut.ball.r50.m1.512.p50", unique in a run
    double value = 0.0;
    std::string unit;            ///< "us", "ms", "s", "B", "1"
    std::optional<double> limit; ///< the value has to be at most this, or with `atLeast` at least
    bool atLeast = false;        ///< more is better
    std::string peer;            ///< who did the same job; empty if nobody did
    std::optional<double> peerValue;
    std::optional<double> ratioAtLeast; ///< how many times better than the peer it has to be, at least

    /// How many times better than the peer; nullopt without a peer.
    std::optional<double> ratio() const;
    bool misses() const; ///< its limit or its ratio is not met
};

/// A figure without a peer.
Figure figure(std::string name, double value, std::string unit, std::optional<double> limit = std::nullopt);
/// The same figure compared with a peer.
Figure against(Figure own, std::string peer, double peerValue, std::optional<double> ratioAtLeast = std::nullopt);

nlohmann::json jsonOf(const std::vector<Figure>& figures);
/// Aligned columns for readers, and a last line that counts the figures that miss their limit.
std::string tableOf(const std::vector<Figure>& figures);
/// One line: how many figures there are and which of them miss.
std::string summaryOf(const std::vector<Figure>& figures);

} // namespace burin::benchmarks
