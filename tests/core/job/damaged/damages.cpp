// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/core/job/damaged/damages.h"

#include "core/nc/control.h"
#include "core/nc/parser.h"
#include "tests/core/job/damaged/tray_job.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <regex>
#include <sstream>
#include <vector>

namespace burin::test {

namespace {

constexpr glm::dvec3 zero{15.0, 10.0, 9.0}; // the tray's program zero, setup frame, mm

/// A program's lines, counted from 1, with its moves.
class Program {
public:
    Program(const std::string& text, const std::string& dialect) : control_(*findControl(dialect)) {
        std::istringstream stream(text);
        for (std::string line; std::getline(stream, line);) lines_.push_back(line);
        parsed_ = parseProgram(text, "sound", control_).value();
    }

    std::uint32_t size() const { return static_cast<std::uint32_t>(lines_.size()); }
    std::string& line(std::uint32_t number) { return lines_.at(number - 1); }
    void insert(std::uint32_t before, const std::string& line) {
        lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(before) - 1, line);
    }
    void remove(std::uint32_t number) { lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(number) - 1); }
    void truncate(std::uint32_t size) { lines_.resize(size); }
    const std::vector<NcMotion>& motions() const { return parsed_.motions; }

    std::string text() const {
        std::string all;
        for (const std::string& line : lines_) all += line + "\n";
        return all;
    }
    Damaged damaged(std::uint32_t first, std::uint32_t last, const std::string& what) const {
        return {text(), what, first, last};
    }

    /// Numbers of the lines that match.
    std::vector<std::uint32_t> matching(const char* expression) const {
        const std::regex wanted(expression);
        std::vector<std::uint32_t> found;
        for (std::uint32_t i = 1; i <= size(); ++i)
            if (std::regex_search(lines_[i - 1], wanted)) found.push_back(i);
        return found;
    }
    void replace(std::uint32_t number, const char* expression, const std::string& by) {
        line(number) = std::regex_replace(line(number), std::regex(expression), by);
    }
    /// Lines with feed moves of a tool.
    std::vector<std::uint32_t> feeding(int tool) const {
        std::vector<std::uint32_t> found;
        for (const NcMotion& motion : parsed_.motions)
            if (!motion.rapid() && motion.kind != NcMotionKind::dwell && (tool == 0 || motion.tool == tool) &&
                (found.empty() || found.back() != motion.line))
                found.push_back(motion.line);
        return found;
    }
    std::uint32_t firstFeedBehind(std::uint32_t number) const {
        for (const std::uint32_t line : feeding(0))
            if (line >= number) return line;
        return size();
    }
    /// Adds to the number of a word; false if the line has no such word.
    bool addTo(std::uint32_t number, char letter, double amount) {
        std::string& text = line(number);
        if (text.starts_with("(") || text.find("G53") != std::string::npos || text.find("G28") != std::string::npos)
            return false;
        const std::size_t at = text.find(letter);
        if (at == std::string::npos) return false;
        std::size_t end = at + 1;
        const double value = std::strtod(text.c_str() + at + 1, nullptr);
        while (end < text.size() && std::string_view("0123456789.-+").find(text[end]) != std::string_view::npos) ++end;
        std::array<char, 32> written{};
        std::snprintf(written.data(), written.size(), "%.3f", value + amount);
        text.replace(at + 1, end - at - 1, written.data());
        return true;
    }
    /// mm, greatest depth of the moves of a text in the part; empty if it can't be read.
    std::optional<double> depth(const std::string& changed) const {
        const Result<ParsedProgram> read = parseProgram(changed, "damaged", control_);
        if (!read) return std::nullopt;
        double deepest = -1e9;
        for (const NcMotion& move : straightMoves(*read, 0.001)) {
            if (!move.startKnown()) continue;
            const double radius = move.tool == 2 ? 1.5 : 3.0;
            const int steps = 1 + static_cast<int>(glm::distance(move.from.linear(), move.to.linear()) / 0.05);
            for (int i = 0; i <= steps; ++i)
                deepest = std::max(deepest, TrayJob::depthInPart(zero + glm::mix(move.from.linear(), move.to.linear(),
                                                                                 static_cast<double>(i) / steps),
                                                                 radius));
        }
        return deepest;
    }

private:
    const Control& control_;
    std::vector<std::string> lines_;
    ParsedProgram parsed_;
};

std::string number(double value) {
    std::array<char, 32> written{};
    std::snprintf(written.data(), written.size(), "%.3f", value);
    return written.data();
}

Damaged unknownTool(const std::string& text, const std::string& dialect, std::uint32_t n) {
    Program program(text, dialect);
    const auto changes = program.matching("^T[0-9]+ M0?6");
    const std::uint32_t line = changes.at(n % changes.size());
    program.replace(line, "^T[0-9]+", "T" + std::to_string(7 + n));
    return program.damaged(line, line, program.line(line));
}

Damaged toolChangeMissing(const std::string& text, const std::string& dialect, std::uint32_t n) {
    Program program(text, dialect);
    const auto changes = program.matching("^T[0-9]+ M0?6");
    const std::uint32_t line = changes.at(n % changes.size()), last = program.firstFeedBehind(line) - 1;
    const std::string what = "without " + program.line(line);
    program.remove(line);
    return program.damaged(line - 1, last, what);
}

Damaged lengthOffsetMissing(const std::string& text, const std::string& dialect, std::uint32_t n) {
    Program program(text, dialect);
    const auto offsets = program.matching("G43");
    const std::uint32_t line = offsets.at(n % offsets.size());
    std::uint32_t last = program.firstFeedBehind(line);
    const std::string what = "without the G43 of " + program.line(line);
    if (program.line(line).find('Z') == std::string::npos) {
        program.remove(line);
        --last;
    } else {
        program.replace(line, "(G43 | H[0-9]+)", "");
    }
    return program.damaged(line, last, what);
}

Damaged lengthOffsetOfAnother(const std::string& text, const std::string& dialect, std::uint32_t n) {
    Program program(text, dialect);
    const auto offsets = program.matching("G43");
    const std::uint32_t line = offsets.at(n % offsets.size());
    const auto own = static_cast<std::uint32_t>(n % offsets.size() + 1);
    const std::uint32_t other = own == 1 ? 2 + n / 2 % 2 : 1 + n / 2 % 2 * 2;
    program.replace(line, "H[0-9]+", "H" + std::to_string(other));
    return program.damaged(line, line, program.line(line));
}

Damaged otherWorkOffset(const std::string& text, const std::string& dialect, std::uint32_t n) {
    Program program(text, dialect);
    const auto offsets = program.matching("G54");
    const std::uint32_t line = offsets.at(n % offsets.size());
    program.replace(line, "G54", "G" + std::to_string(55 + n % 5));
    return program.damaged(line, line, program.line(line));
}

Damaged anticlockwise(const std::string& text, const std::string& dialect, std::uint32_t n) {
    Program program(text, dialect);
    const auto starts = program.matching("^S[0-9]+ M0?3");
    const std::uint32_t line = starts.at(n % starts.size());
    program.replace(line, "M(0?)3", "M$014");
    return program.damaged(line, line, program.line(line));
}

Damaged endMissing(const std::string& text, const std::string& dialect, std::uint32_t n) {
    Program program(text, dialect);
    std::uint32_t last = program.size();
    while (program.line(last).starts_with("M2") || program.line(last).starts_with("M30") || program.line(last) == "%")
        --last;
    last -= n * 3; // an interrupted transfer
    program.truncate(last);
    return program.damaged(last, last, "ends behind line " + std::to_string(last));
}

/// Inserts another G64 among the finishing moves, before the last move at which corners matter.
Damaged blended(const std::string& text, const std::string& dialect, const std::string& words, std::uint32_t n) {
    Program program(text, dialect);
    if (n == 0) {
        const std::uint32_t line = program.matching("^G64").front();
        program.line(line) = words;
        return program.damaged(line, line, words);
    }
    const auto finishing = program.feeding(2);
    const std::uint32_t line = finishing.at(n * 2);
    program.insert(line, words);
    return program.damaged(line, line, words);
}
Damaged blendUnlimited(const std::string& text, const std::string& dialect, std::uint32_t n) {
    return blended(text, dialect, "G64", n);
}
Damaged blendWide(const std::string& text, const std::string& dialect, std::uint32_t n) {
    constexpr std::array<double, 10> tolerances{1.0, 2.0, 0.5, 0.3, 0.2, 1.5, 0.7, 5.0, 0.25, 0.4};
    return blended(text, dialect, "G64 P" + number(tolerances.at(n % 10)), n);
}

/// Lines of rapids that end at the clearance height and have X, Y and Z.
std::vector<NcMotion> travelling(const Program& program) {
    std::vector<NcMotion> found;
    const std::vector<NcMotion>& motions = program.motions();
    for (std::size_t i = 0; i + 1 < motions.size(); ++i)
        if (motions[i].rapid() && motions[i].startKnown() && motions[i].toKnown.has(Axis::z) &&
            motions[i].to[Axis::z] > 3.0 && motions[i + 1].line != motions[i].line && motions[i + 1].rapid() &&
            motions[i + 1].toKnown.has(Axis::z) && motions[i + 1].workOffset == 54)
            found.push_back(motions[i]);
    return found;
}

Damaged shifted(const std::string& text, const std::string& dialect, std::uint32_t n) {
    const Program sound(text, dialect);
    const auto places = travelling(sound);
    constexpr std::array<double, 10> amounts{0.3, -0.3, 0.15, 0.5, -0.5, 1.0, 0.2, -1.0, 0.4, 0.7};
    const double amount = amounts.at(n % 10);
    const bool sideways = n % 3 == 2;
    for (std::size_t i = 0; i < places.size(); ++i) {
        Program program = sound;
        const NcMotion& place = places.at((n * 3 + i) % places.size());
        const std::string line =
            sideways ? "G92 X" + number(place.to[Axis::x] - amount) : "G92 Z" + number(place.to[Axis::z] - amount);
        program.insert(place.line + 1, line);
        const std::optional<double> depth = sound.depth(program.text());
        if ((sideways || amount < 0.0) && depth && *depth < 0.05) continue; // without effect from here on
        return program.damaged(place.line + 1, place.line + 1, line);
    }
    return {};
}

Damaged everythingMoved(const std::string& text, const std::string& dialect, char letter, double amount) {
    Program program(text, dialect);
    std::uint32_t first = 0, last = 0;
    for (const NcMotion& motion : program.motions()) {
        if (motion.line == last) continue;
        if (!program.addTo(motion.line, letter, amount)) continue;
        if (first == 0) first = motion.line;
        last = motion.line;
    }
    return program.damaged(first, last, std::string("all ") + letter + " + " + number(amount));
}
Damaged allHigher(const std::string& text, const std::string& dialect, std::uint32_t n) {
    constexpr std::array<double, 10> amounts{0.3, 0.3, 0.3, 0.3, 0.3, 0.15, 0.2, 0.5, 1.0, 0.8};
    return everythingMoved(text, dialect, 'Z', amounts.at(n % 10));
}
Damaged wrongZero(const std::string& text, const std::string& dialect, std::uint32_t n) {
    constexpr std::array<double, 10> amounts{0.3, -0.3, 1.0, -1.0, 5.0, -5.0, 0.15, -0.2, 0.7, 15.0};
    return everythingMoved(text, dialect, n % 2 == 0 ? 'X' : 'Y', amounts.at(n % 10));
}

/// Past the block's side before anything is cut, or along the wall of allowance inside: by less than half a voxel.
Damaged grazingRapid(const std::string& text, const std::string& dialect, std::uint32_t n) {
    Program program(text, dialect);
    if (n % 2 == 0) {
        const std::uint32_t line = program.feeding(1).front();
        const double by = 0.05 + 0.02 * n;
        const NcMotion start = *std::ranges::find(program.motions(), line, &NcMotion::line);
        const std::array<std::string, 6> added{
            "G0 Z6.000", "X-33.000 Y" + number(-3.0 - 3.0 + by - zero.y),
            "Z-4.000",   "X33.000",
            "Z6.000",    "X" + number(start.from[Axis::x]) + " Y" + number(start.from[Axis::y])};
        for (std::uint32_t i = 0; i < added.size(); ++i) program.insert(line + i, added.at(i));
        program.insert(line + 6, "Z" + number(start.from[Axis::z]));
        return program.damaged(line + 3, line + 3, "grazes by " + number(by));
    }
    const std::uint32_t line = program.feeding(2).front();
    const double by = 0.03 + 0.01 * n;
    program.insert(line, "G0 X" + number(3.3 + 1.5 - by - zero.x));
    program.insert(line + 1, "X0.000");
    return program.damaged(line, line, "grazes by " + number(by));
}

/// Changes one word of one of the lines so that the tool gouges, or the control can't read on.
Damaged changedWord(Program program, const std::vector<std::uint32_t>& lines, const std::string& letters,
                    std::uint32_t seed) {
    std::mt19937 random(seed + 17);
    for (int attempt = 0; attempt < 400; ++attempt) {
        Program changed = program;
        const std::uint32_t line = lines.at(random() % lines.size());
        const char letter = letters.at(random() % letters.size());
        const double amount = (random() % 2 == 0 ? 1.0 : -1.0) * (0.2 + 0.1 * static_cast<double>(random() % 40));
        if (!changed.addTo(line, letter, amount)) continue;
        const std::optional<double> depth = changed.depth(changed.text());
        if (depth && *depth < 0.05) continue;
        return changed.damaged(line, line, program.line(line) + " -> " + changed.line(line));
    }
    return {};
}

/// Lines of straight feed moves before a motion of a kind.
std::vector<std::uint32_t> linesBefore(const Program& program, NcMotionKind kind) {
    std::vector<std::uint32_t> lines;
    const std::vector<NcMotion>& motions = program.motions();
    for (std::size_t i = 0; i + 1 < motions.size(); ++i)
        if (motions[i].kind == NcMotionKind::line && motions[i + 1].kind == kind) lines.push_back(motions[i].line);
    return lines;
}

Damaged movedEnd(const std::string& text, const std::string& dialect, std::uint32_t n) {
    const Program program(text, dialect);
    return changedWord(program, linesBefore(program, NcMotionKind::line), "XYZ", n);
}

Damaged movedEndBeforeAnArc(const std::string& text, const std::string& dialect, std::uint32_t n) {
    const Program program(text, dialect);
    return changedWord(program, linesBefore(program, NcMotionKind::arc), "XY", n);
}

Damaged damagedArc(const std::string& text, const std::string& dialect, std::uint32_t n) {
    const Program program(text, dialect);
    std::vector<std::uint32_t> lines;
    for (const NcMotion& motion : program.motions())
        if (motion.kind == NcMotionKind::arc) lines.push_back(motion.line);
    return changedWord(program, lines, "XYIJ", n);
}

Damaged incremental(const std::string& text, const std::string& dialect, std::uint32_t n) {
    Program program(text, dialect);
    const auto feeding = program.feeding(0);
    const std::uint32_t line = feeding.at((3 + 7 * n) % (feeding.size() - 15));
    program.insert(line, "G91");
    return program.damaged(line, line, "G91");
}

Damaged spindleOff(const std::string& text, const std::string& dialect, std::uint32_t n) {
    Program program(text, dialect);
    if (n % 2 == 0) {
        const auto starts = program.matching("^S[0-9]+ M0?3");
        const std::uint32_t line = starts.at(n / 2 % starts.size()), last = program.firstFeedBehind(line);
        const std::string what = "without M3";
        program.replace(line, " M0?3", "");
        return program.damaged(line, last, what);
    }
    const auto feeding = program.feeding(dialect == "grbl" ? 0 : 1);
    const std::uint32_t line = feeding.at((5 + 3 * n) % (feeding.size() - 10));
    program.insert(line, "M5");
    return program.damaged(line, line, "M5");
}

constexpr std::array<std::string_view, 6> all{"linuxcnc", "fanuc", "haas", "mach", "grblhal", "grbl"};
constexpr std::array<std::string_view, 5> changing{"linuxcnc", "fanuc", "haas", "mach", "grblhal"};
constexpr std::array<std::string_view, 1> linuxCnc{"linuxcnc"};

constexpr std::array<DamageKind, 18> kinds{{
    {"tool unknown", changing, unknownTool},
    {"tool change missing", changing, toolChangeMissing},
    {"length offset missing", changing, lengthOffsetMissing},
    {"length offset of another tool", changing, lengthOffsetOfAnother},
    {"other work offset", all, otherWorkOffset},
    {"spindle anticlockwise", all, anticlockwise},
    {"end missing", changing, endMissing},
    {"blended without limit", linuxCnc, blendUnlimited},
    {"blended widely", linuxCnc, blendWide},
    {"shifted by G92", all, shifted},
    {"all higher", all, allHigher},
    {"wrong zero", all, wrongZero},
    {"grazing rapid", changing, grazingRapid},
    {"moved end", all, movedEnd},
    {"moved end before an arc", all, movedEndBeforeAnArc},
    {"damaged arc", all, damagedArc},
    {"incremental", all, incremental},
    {"spindle off", all, spindleOff},
}};

} // namespace

std::span<const DamageKind> damageKinds() {
    return kinds;
}

} // namespace burin::test
