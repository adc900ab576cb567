// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace burin {

/// Random programs that LinuxCNC accepts: all motions, planes and cycles, both units, offsets, shifts and feed modes.
class RandomProgram {
public:
    std::string text() {
        text_ = "G21 G17 G90 G40 G49 G94 S1000 M3\nG0 X1 Y2 Z3\nG1 F300 X2\n";
        const int count = *rc::gen::inRange(1, 40);
        for (int i = 0; i < count; ++i) piece();
        return text_ + "M2\n";
    }

private:
    static int below(int count) { return *rc::gen::inRange(0, count); }
    static double length() { return *rc::gen::inRange(-90000, 90001) / 1000.0; }
    static double positive() { return *rc::gen::inRange(100, 30000) / 1000.0; }
    static std::string number(double value) { return rc::toString(std::round(value * 10000.0) / 10000.0); }
    std::string word(char letter, double value) const {
        char buffer[40];
        std::snprintf(buffer, sizeof buffer, " %c%.4f", letter, inch_ ? value / 25.4 : value);
        return buffer;
    }
    char axis(int which) const { return "XYZ"[(plane_ + 1 + which) % 3]; }
    char offset(int which) const { return "IJK"[(plane_ + 1 + which) % 3]; }

    void piece() {
        switch (below(14)) {
        case 0:
            plane_ = below(3);
            text_ += plane_ == 2 ? "G17\n" : plane_ == 1 ? "G18\n" : "G19\n";
            break;
        case 1:
            inch_ = !inch_;
            text_ += inch_ ? "G20\n" : "G21\n";
            break;
        case 2:
            text_ +=
                "G10 L" + std::string(below(2) == 0 ? "2" : "20") + " P" + std::to_string(below(10)) + words() + "\n";
            break;
        case 3:
            text_ += std::string(below(2) == 0 ? "G92" : "G52") + words() + "\n";
            break;
        case 4:
            text_ += std::string("G") +
                     (below(4) == 0 ? "59." + std::to_string(1 + below(3)) : std::to_string(54 + below(6))) + "\n";
            break;
        case 5: {
            static const char* const texts[] = {"G92.1", "G92.2", "G92.3", "G28.1", "G30.1", "G28", "G30"};
            text_ += std::string(texts[below(7)]) + "\n";
            break;
        }
        case 6:
            text_ += std::string(below(2) == 0 ? "G28" : "G53 G0") + words() + "\n";
            break;
        case 7:
            text_ += "G4 P" + number(positive()) + "\n";
            break;
        case 8:
        case 9:
            cycle();
            break;
        case 10:
            text_ += "G93 G1" + words() + " F" + number(positive()) + "\nG94 F200\n";
            break;
        case 11:
            text_ += std::string("G91 G1") + words() + "\nG90\n";
            break;
        case 12:
            text_ += std::string(below(2) == 0 ? "G0" : "G1") + words() + "\n";
            break;
        default:
            arc();
            break;
        }
    }

    /// At least one of X Y Z.
    std::string words() const {
        const int mask = 1 + below(7);
        std::string result;
        for (int i = 0; i < 3; ++i)
            if ((mask & (1 << i)) != 0) result += word("XYZ"[i], length());
        return result;
    }

    /// Incremental, so that its end is valid wherever it begins.
    void arc() {
        const double u = positive() * (below(2) == 0 ? 1.0 : -1.0), v = positive() * (below(2) == 0 ? 1.0 : -1.0);
        const double angle = below(1000) / 1000.0 * 6.283185307179586;
        const double du = u - u * std::cos(angle) + v * std::sin(angle),
                     dv = v - u * std::sin(angle) - v * std::cos(angle);
        std::string line = std::string("G91 G") + (below(2) == 0 ? "2" : "3");
        const int form = below(4);
        if (form == 0 && std::hypot(du, dv) > 0.5) { // by radius
            const double radius = 0.5 * std::hypot(du, dv) * (1.01 + below(100) / 50.0);
            line += word(axis(0), du) + word(axis(1), dv) + word('R', below(2) == 0 ? radius : -radius);
        } else {
            if (form != 1 && std::hypot(du, dv) > 0.5) line += word(axis(0), du) + word(axis(1), dv);
            line += word(offset(0), u) + word(offset(1), v);
            if (form == 2) line += " P" + std::to_string(1 + below(4));
        }
        if (below(2) == 0) line += word(axis(2), length());
        text_ += line + " F500\nG90\n";
    }

    void cycle() {
        static const char* const codes[] = {"G73", "G81", "G82", "G83", "G85", "G86", "G87", "G88", "G89"};
        const int which = below(9);
        const bool incremental = below(2) == 0;
        text_ += std::string("G0") + word(axis(2), length()) + "\n";
        const double height = length() + 100.0, depth = positive();
        std::string line = std::string(incremental ? "G91 " : "G90 ") + (below(2) == 0 ? "G98 " : "G99 ") +
                           codes[which] + word(axis(0), length()) + word(axis(1), length());
        line += word('R', incremental ? length() : height) + word(axis(2), incremental ? -depth : height - depth);
        if (which == 2 || which == 5 || which >= 7) line += " P" + number(positive() / 10.0);
        if (which == 0 || which == 3) line += word('Q', depth / (1.5 + below(5)));
        if (which == 6) {
            line += word(offset(0), length()) + word(offset(1), length());
            line += word(offset(2), incremental ? depth / 2.0 : height - depth / 2.0);
        }
        if (below(2) == 0) line += " L" + std::to_string(1 + below(3));
        text_ += line + "\n";
        for (int again = below(3); again > 0; --again) text_ += std::string(" ").append(word(axis(0), length())) + "\n";
        text_ += "G80 G90\n";
    }

    std::string text_;
    int plane_ = 2;
    bool inch_ = false;
};

inline std::string randomProgram() {
    return RandomProgram().text();
}

} // namespace burin
