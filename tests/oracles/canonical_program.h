// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <QString>

#include <vector>

namespace burin {

enum class CanonicalKind { rapid, line, arc, dwell };

/// A canonical call of LinuxCNC's interpreter that moves or waits. Lengths are in the unit of the block.
struct CanonicalMove {
    CanonicalKind kind = CanonicalKind::rapid;
    glm::dvec3 to{0.0};               ///< including the shifts of G92 and G52, as in NcMotion
    glm::dvec3 rotary{0.0};           ///< A, B, C, degrees
    glm::dvec3 centre{0.0};           ///< arc; its component along the axis is 0
    int axis = 2;                     ///< arc
    int turns = 0;                    ///< arc: number of turns begun, negative for clockwise
    double feed = 0.0;                ///< mm/min, or mm per revolution, as last set
    double seconds = 0.0;             ///< dwell
    double spindleSpeed = 0.0;        ///< 1/min; 0: the spindle is stopped
    bool mist = false, flood = false; ///< coolant
    double unit = 1.0;                ///< mm
    double doubt = 1e-4; ///< uncertainty of lengths, because four decimals are printed; of a shift too, in the unit in
                         ///< which it was set
};

/// The output of LinuxCNC's stand-alone interpreter, rs274, for a program. It runs with a home folder of its own (it
/// rewrites a file there) and tools 1 to 7 of length 0; the machine is at 0 and all its offsets are 0.
struct CanonicalProgram {
    int exitCode = -1;
    QString complaint;
    std::vector<CanonicalMove> moves;

    static bool available();
    explicit CanonicalProgram(const QString& file);
    static CanonicalProgram ofText(const std::string& text);

private:
    CanonicalProgram() = default;
    void readCalls(const QString& output);
};

} // namespace burin
