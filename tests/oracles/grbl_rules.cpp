// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/grbl_rules.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <vector>

namespace burin {
namespace {

using Words = std::vector<std::pair<char, double>>;

/// Modal group by ten times the G number; absent: unsupported (error 20).
const std::map<int, char>& gGroups() {
    static const std::map<int, char> table{
        {40, 'x'},  {100, 'x'}, {280, 'x'}, {281, 'x'}, {300, 'x'}, {301, 'x'}, {530, 'x'}, {920, 'x'},
        {921, 'x'}, {0, 'm'},   {10, 'm'},  {20, 'm'},  {30, 'm'},  {382, 'm'}, {383, 'm'}, {384, 'm'},
        {385, 'm'}, {800, 'm'}, {170, 'p'}, {180, 'p'}, {190, 'p'}, {900, 'd'}, {910, 'd'}, {911, 'a'},
        {930, 'f'}, {940, 'f'}, {200, 'u'}, {210, 'u'}, {400, 'c'}, {431, 'l'}, {490, 'l'}, {540, 'w'},
        {550, 'w'}, {560, 'w'}, {570, 'w'}, {580, 'w'}, {590, 'w'}, {610, 't'}};
    return table;
}

const std::map<int, char>& mGroups() {
    static const std::map<int, char> table{{0, 's'}, {1, 's'}, {2, 's'}, {30, 's'}, {3, 'r'},
                                           {4, 'r'}, {5, 'r'}, {8, 'k'}, {9, 'k'}}; // M7: only if compiled in
    return table;
}

/// The characters that reach the parser: without blanks, comments and /, in upper case.
std::string stripped(const std::string& line) {
    std::string result;
    bool comment = false;
    for (const char c : line) {
        if (comment) {
            comment = c != ')';
        } else if (c == '(') {
            comment = true;
        } else if (c == ';') {
            break;
        } else if (c > ' ' && c != '/') {
            result += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        }
    }
    return result;
}

/// 0, or the error number if the line cannot be split into words.
int split(const std::string& line, Words& words) {
    std::size_t at = 0;
    while (at < line.size()) {
        const char letter = line[at++];
        if (letter < 'A' || letter > 'Z') return 1;
        std::size_t end = at;
        if (end < line.size() && (line[end] == '-' || line[end] == '+')) ++end;
        bool digit = false, point = false;
        for (; end < line.size(); ++end) {
            if (line[end] == '.' && !point)
                point = true;
            else if (line[end] >= '0' && line[end] <= '9')
                digit = true;
            else
                break;
        }
        if (!digit) return 2;
        words.emplace_back(letter, std::strtod(line.substr(at, end - at).c_str(), nullptr));
        at = end;
    }
    return 0;
}

class Grbl {
public:
    int read(const std::string& raw) {
        const std::string line = stripped(raw);
        if (line.empty()) return 0;
        if (line.size() > 79) return 11;
        Words words;
        if (const int error = split(line, words); error != 0) return error;
        if (const int error = sort(words); error != 0) return error;
        return carryOut();
    }

private:
    bool has(char letter) const { return values_.contains(letter); }
    double value(char letter) const { return values_.at(letter); }
    bool hasAxis() const { return has('X') || has('Y') || has('Z'); }

    int sort(const Words& words) {
        values_.clear();
        groups_.clear();
        for (const auto& [letter, number] : words) {
            if (letter == 'G' || letter == 'M') {
                const int tenfold = static_cast<int>(std::lround(number * 10.0));
                const auto& table = letter == 'G' ? gGroups() : mGroups();
                const int key = letter == 'G' ? tenfold : tenfold % 10 == 0 ? tenfold / 10 : -1;
                const auto found = table.find(key);
                if (found == table.end()) return 20;
                if (!groups_.emplace(found->second, key).second) return 21;
                continue;
            }
            static const std::string known = "FIJKLNPRSTXYZ";
            if (known.find(letter) == std::string::npos) return 20;
            if (!values_.emplace(letter, number).second) return 25;
            if (number < 0.0 && (letter == 'F' || letter == 'N' || letter == 'P' || letter == 'T' || letter == 'S'))
                return 4;
        }
        return 0;
    }

    /// Executes codes that use the axis words, or the motion in force if there is none.
    int carryOut() {
        const auto group = [this](char which) { return groups_.contains(which) ? groups_.at(which) : -1; };
        if (has('N') && (value('N') > 1e7 || value('N') != std::floor(value('N')))) return 27;
        if (group('f') >= 0) {
            if (inverse_ != (group('f') == 930)) feed_ = 0.0;
            inverse_ = group('f') == 930;
        }
        if (group('u') >= 0) inch_ = group('u') == 200;
        const int once = group('x');
        const bool onceUsesAxes = once == 100 || once == 280 || once == 300 || once == 920;
        const bool lengthUsesAxes = group('l') == 431;
        const bool newMotion = group('m') >= 0 && group('m') != 800;
        if ((onceUsesAxes && (newMotion || lengthUsesAxes)) || (lengthUsesAxes && newMotion)) return 24;
        if (has('F')) feed_ = value('F');
        if (once == 40) {
            if (!has('P')) return 28;
            used_ = {'P'};
        } else {
            used_.clear();
        }
        if (group('p') >= 0) axis_ = group('p') == 170 ? 2 : group('p') == 180 ? 1 : 0;
        if (lengthUsesAxes && (has('X') || has('Y') || !has('Z'))) return 37;
        if (group('d') >= 0) incremental_ = group('d') == 910;
        if (once == 920 && !hasAxis()) return 26;
        if (once == 100) {
            if (!hasAxis()) return 26;
            if (!has('P') || !has('L')) return 28;
            if (value('L') != 2.0 && value('L') != 20.0) return 20;
            used_ = {'P', 'L'};
        }
        if (group('m') >= 0) motion_ = group('m');
        if (once == 530 && motion_ != 0 && motion_ != 10) return 30;
        const bool takesAxes = onceUsesAxes || lengthUsesAxes;
        if (motion_ == 800 && hasAxis() && !takesAxes) return 31;
        int error = 0;
        if (!takesAxes && (newMotion || hasAxis()) && motion_ != 800) error = move();
        if (error != 0) return error;
        for (const char letter : {'I', 'J', 'K', 'L', 'P', 'R'})
            if (has(letter) && !used_.contains(letter)) return 36;
        if (group('s') == 2 || group('s') == 30) setBack();
        return 0;
    }

    /// Resets the modes as M2 and M30 do: the program ends, and lines that follow are still read.
    void setBack() {
        motion_ = 10;
        axis_ = 2;
        inverse_ = incremental_ = false;
    }

    int move() {
        std::array<double, 3> target = place_;
        const double unit = inch_ ? 25.4 : 1.0;
        for (std::size_t i = 0; i < 3; ++i) {
            const char letter = static_cast<char>('X' + static_cast<int>(i));
            if (has(letter)) target[i] = value(letter) * unit + (incremental_ ? place_[i] : 0.0);
        }
        if (motion_ == 0) {
            place_ = target;
            return 0;
        }
        if (inverse_ ? !has('F') : feed_ == 0.0) return 22;
        if (motion_ == 10) {
            place_ = target;
            return 0;
        }
        if (motion_ > 30) return hasAxis() ? 0 : 26;
        if (!hasAxis()) return 26;
        const std::size_t u = static_cast<std::size_t>((axis_ + 1) % 3), v = static_cast<std::size_t>((axis_ + 2) % 3);
        if (!has("XYZ"[u]) && !has("XYZ"[v])) return 32;
        const double du = target[u] - place_[u], dv = target[v] - place_[v];
        if (has('R')) {
            if (du == 0.0 && dv == 0.0) return 33;
            const double radius = value('R') * unit;
            if (4.0 * radius * radius - du * du - dv * dv < 0.0) return 34;
            used_.insert('R');
        } else {
            if (!has("IJK"[u]) && !has("IJK"[v])) return 35;
            const double i = has("IJK"[u]) ? value("IJK"[u]) * unit : 0.0,
                         j = has("IJK"[v]) ? value("IJK"[v]) * unit : 0.0;
            const double start = std::hypot(i, j), end = std::hypot(du - i, dv - j);
            const double difference = std::abs(end - start);
            if (difference > 0.005 && (difference > 0.5 || difference > 0.001 * start)) return 33;
            used_.insert("IJK"[u]);
            used_.insert("IJK"[v]);
        }
        place_ = target;
        return 0;
    }

    std::map<char, double> values_;
    std::map<char, int> groups_;
    std::set<char> used_;
    std::array<double, 3> place_{};
    double feed_ = 0.0;
    int motion_ = 0; // GRBL starts in G0
    int axis_ = 2;
    bool inverse_ = false, inch_ = false, incremental_ = false;
};

} // namespace

GrblVerdict grblVerdict(const std::string& program) {
    Grbl grbl;
    std::istringstream lines(program);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number)
        if (const int error = grbl.read(line); error != 0) return {error, number};
    return {};
}

} // namespace burin
