// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace burin::haply {

/// How a version of the service names the components of a force.
enum class ForceKey : std::uint8_t {
    vector, ///< 3.5
    values  ///< 3.1 and most public programs
};

/// Writes the only message of a tick: the force of an arm. Prepared beforehand except for the numbers, so that a tick
/// does not allocate. One thread.
class ForceMessage {
public:
    static constexpr double largest = 1000.0; ///< N, for each component; more than any arm renders

    /// @param arm device id, as reported by the service
    explicit ForceMessage(std::string_view arm);
    /// @param force N; NaN is sent as 0, and values beyond `largest` as `largest`. @return valid until the next call
    std::string_view write(const glm::dvec3& force, ForceKey key) noexcept;

private:
    std::array<std::string, 2> heads_; ///< by key
    std::string buffer_;               ///< long enough for either form with three numbers
};

} // namespace burin::haply
