// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/block.h"

#include <charconv>
#include <cmath>

namespace burin {
namespace {

constexpr std::string_view wordLetters = "FGHIJKMNPQSTXYZ";
constexpr double largestNumber = 1e7; // beyond any machine; keeps sums and counts of chords finite

bool isBlank(char c) noexcept {
    return c == ' ' || c == '\t';
}
bool isDigit(char c) noexcept {
    return c >= '0' && c <= '9';
}

int groupOf(GGroup group) noexcept {
    return static_cast<int>(group);
}

/// Modal group of a G number times ten; -1 for words that Burin does not read.
int gGroup(int number) noexcept {
    switch (number) {
    case 0:
    case 10:
    case 20:
    case 30:
    case 800:
        return groupOf(GGroup::motion);
    case 40:
        return groupOf(GGroup::dwell);
    case 170:
    case 180:
    case 190:
        return groupOf(GGroup::plane);
    case 200:
    case 210:
        return groupOf(GGroup::units);
    case 400:
        return groupOf(GGroup::compensation);
    case 430:
    case 490:
        return groupOf(GGroup::lengthOffset);
    case 540:
    case 550:
    case 560:
    case 570:
    case 580:
    case 590:
        return groupOf(GGroup::workOffset);
    case 610:
    case 640:
        return groupOf(GGroup::control);
    case 900:
    case 910:
        return groupOf(GGroup::distance);
    case 911:
        return groupOf(GGroup::arcDistance);
    case 940:
        return groupOf(GGroup::feedMode);
    default:
        return -1;
    }
}

/// Modal group of an M number times ten; -1 for words that Burin does not read.
int mGroup(int number) noexcept {
    switch (number) {
    case 0:
    case 10:
    case 20:
    case 300:
        return static_cast<int>(MGroup::stop);
    case 60:
        return static_cast<int>(MGroup::toolChange);
    case 30:
    case 40:
    case 50:
        return static_cast<int>(MGroup::spindle);
    case 70:
    case 80:
    case 90:
        return static_cast<int>(MGroup::coolant);
    default:
        return -1;
    }
}

/// Walks over one line.
class Reader {
public:
    Reader(std::string_view line, Block& block, BlockFault& fault) noexcept
        : line_(line), block_(block), fault_(fault) {}

    bool read() noexcept {
        if (!skip()) return false;
        if (atEnd()) return true;
        if (line_[at_] == '%') return tapeMark();
        if (line_[at_] == '/') {
            ++at_;
            if (!skip()) return false;
        }
        while (!atEnd()) {
            if (!word() || !skip()) return false;
        }
        return true;
    }

private:
    bool atEnd() const noexcept { return at_ >= line_.size(); }

    bool fail(std::size_t from, std::string_view reason) noexcept {
        std::size_t end = at_ > from ? at_ : from + 1;
        if (end > line_.size()) end = line_.size();
        fault_ = {static_cast<std::uint32_t>(from + 1), reason, from < end ? line_.substr(from, end - from) : ""};
        return false;
    }

    /// Over blanks and comments.
    bool skip() noexcept {
        while (!atEnd()) {
            const char c = line_[at_];
            if (isBlank(c)) {
                ++at_;
            } else if (c == ';') {
                at_ = line_.size();
            } else if (c == '(') {
                const std::size_t close = line_.find_first_of("()", at_ + 1);
                if (close == std::string_view::npos) return fail(at_, "comment is not closed");
                if (line_[close] == '(') return fail(close, "comment inside a comment");
                at_ = close + 1;
            } else {
                return true;
            }
        }
        return true;
    }

    bool tapeMark() noexcept {
        block_.percent = true;
        ++at_;
        if (!skip()) return false;
        return atEnd() || fail(at_, "% has to stand alone");
    }

    /// Decimal number without exponent. Up to 15 digits are exact in the integer and so is the power of ten, hence
    /// their quotient is the nearest double (the common, fast case).
    bool number(std::size_t word, double& value) noexcept {
        while (!atEnd() && isBlank(line_[at_])) ++at_;
        bool negative = false;
        if (!atEnd() && (line_[at_] == '-' || line_[at_] == '+')) negative = line_[at_++] == '-';
        const std::size_t first = at_;
        std::uint64_t digits = 0;
        std::size_t count = 0, decimals = 0;
        bool point = false;
        for (; !atEnd() && (isDigit(line_[at_]) || (line_[at_] == '.' && !point)); ++at_) {
            if (line_[at_] == '.') {
                point = true;
                continue;
            }
            if (count < 15) digits = digits * 10 + static_cast<std::uint64_t>(line_[at_] - '0');
            ++count;
            if (point) ++decimals;
        }
        if (count == 0) return fail(word, "word without a number");
        if (count <= 15) {
            static constexpr std::array<double, 16> powers{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                           1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
            value = static_cast<double>(digits) / powers[decimals];
        } else {
            const auto [end, error] =
                std::from_chars(line_.data() + first, line_.data() + at_, value, std::chars_format::fixed);
            if (error != std::errc{}) return fail(word, "number is out of range");
        }
        if (value > largestNumber) return fail(word, "number is out of range");
        if (negative) value = -value;
        return true;
    }

    bool word() noexcept {
        const std::size_t start = at_;
        char letter = line_[at_];
        if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
        if (letter < 'A' || letter > 'Z') return fail(start, "not a word");
        ++at_;
        if (wordLetters.find(letter) == std::string_view::npos) return fail(start, "word is not read by Burin");
        double value = 0.0;
        if (!number(start, value)) return false;
        const bool first = block_.firstColumn == 0;
        if (first) block_.firstColumn = static_cast<std::uint32_t>(start + 1);
        if (letter == 'N') return first || fail(start, "line number has to stand first");
        if (letter == 'G' || letter == 'M') return code(letter, start, value);
        Word& word = block_.words[static_cast<std::size_t>(letter - 'A')];
        if (word.given()) return fail(start, "word stands twice");
        word = {value, static_cast<std::uint32_t>(start + 1)};
        return true;
    }

    bool code(char letter, std::size_t start, double value) noexcept {
        const double tenfold = value * 10.0;
        const int number = static_cast<int>(std::lround(tenfold));
        const bool exact = std::abs(tenfold - number) < 1e-6;
        const int group = !exact ? -1 : letter == 'G' ? gGroup(number) : mGroup(number);
        if (group < 0) return fail(start, "word is not read by Burin");
        Code& place =
            letter == 'G' ? block_.g[static_cast<std::size_t>(group)] : block_.m[static_cast<std::size_t>(group)];
        if (place.given()) return fail(start, "two words of one modal group");
        place = {number, static_cast<std::uint32_t>(start + 1)};
        return true;
    }

    std::string_view line_;
    Block& block_;
    BlockFault& fault_;
    std::size_t at_ = 0;
};

} // namespace

bool readBlock(std::string_view line, Block& block, BlockFault& fault) noexcept {
    block = Block{};
    return Reader(line, block, fault).read();
}

} // namespace burin
