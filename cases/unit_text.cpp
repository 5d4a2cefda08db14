// SPDX-License-Identifier: MIT
#include "cases/unit_text.hpp"

#include "cases/symbols.hpp"

#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

namespace cases {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 20> spellings{
    {{"·", "*"},      {"⋅", "*"},      {"∙", "*"},      {"•", "*"},        {"×", "*"},
     {"**", "^"},     {"∕", "/"},      {"⁄", "/"},      {"÷", "/"},        {"\u00B5", "u"},
     {"\u03BC", "u"}, {"\u2212", "-"}, {"\u2013", "-"}, {"\u2010", "-"},   {"°", "deg"},
     {"\u00A0", " "}, {"\u2009", " "}, {"\u202F", " "}, {"Å", "angstrom"}, {"\t", " "}}};
constexpr std::array<std::pair<std::string_view, char>, 12> superscripts{{{"⁰", '0'},
                                                                          {"¹", '1'},
                                                                          {"²", '2'},
                                                                          {"³", '3'},
                                                                          {"⁴", '4'},
                                                                          {"⁵", '5'},
                                                                          {"⁶", '6'},
                                                                          {"⁷", '7'},
                                                                          {"⁸", '8'},
                                                                          {"⁹", '9'},
                                                                          {"⁻", '-'},
                                                                          {"⁺", '+'}}};

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

// Bytes above ASCII belong to a symbol, so that an unknown sign is named whole.
bool is_letter(char c) {
    const auto u = static_cast<unsigned char>(c);
    return std::isalpha(u) != 0 || c == '_' || c == '%' || u >= 0x80;
}

Unit power(Unit unit, const scaling::Rational& p) {
    if (p != scaling::Rational(1))
        unit.factor = std::pow(unit.factor, boost::rational_cast<double>(p));
    unit.dimension = scaling::power(unit.dimension, p);
    unit.current *= p;
    unit.angle *= p;
    return unit;
}

Unit product(const Unit& a, const Unit& b) {
    Unit unit;
    unit.factor = a.factor * b.factor;
    unit.dimension = a.dimension * b.dimension;
    unit.current = a.current + b.current;
    unit.angle = a.angle + b.angle;
    unit.counts_cycles = a.counts_cycles || b.counts_cycles;
    return unit;
}

// Recursive descent; `at_` is the next byte to read.
class Parser {
  public:
    explicit Parser(const std::string& text) : text_(text) {}

    Unit whole() {
        Unit unit = expression();
        if (at_ != text_.size())
            throw UnitProblem(text_.substr(at_), "must be units joined by *, / or a space");
        unit.text = text_;
        return unit;
    }

  private:
    Unit expression() {
        skip_spaces();
        Unit unit = divides() ? Unit{} : factor();  // "/s" as in "60 /s"
        for (;;) {
            const bool space = skip_spaces();
            if (at_ == text_.size() || text_[at_] == ')') return unit;
            if (divides()) {
                at_ += text_[at_] == '/' ? 1 : 4;
                unit = product(unit, power(factor(), -1));
            } else if (text_[at_] == '*' || text_[at_] == '.') {
                ++at_;
                unit = product(unit, factor());
            } else if (space) {
                unit = product(unit, factor());
            } else {
                return unit;
            }
        }
    }

    Unit factor() {
        skip_spaces();
        Unit unit;
        if (at_ < text_.size() && text_[at_] == '(') {
            ++at_;
            unit = expression();
            expect(')');
        } else if (at_ < text_.size() && text_[at_] == '1' &&
                   (at_ + 1 == text_.size() || !is_digit(text_[at_ + 1]))) {
            ++at_;  // as in 1/s
            return unit;
        } else {
            unit = symbol();
        }
        return power(unit, exponent());
    }

    Unit symbol() {
        const std::size_t from = at_;
        while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
        const std::string name = text_.substr(from, at_ - from);
        if (name.empty()) throw UnitProblem(text_.substr(from), "must have a unit's symbol here");
        const std::optional<Unit> unit = find_symbol(name);
        if (!unit) throw UnitProblem(name, "must be a known unit");
        return *unit;
    }

    scaling::Rational exponent() {
        if (at_ == text_.size()) return 1;
        if (text_[at_] == '^') {
            ++at_;
            if (at_ < text_.size() && text_[at_] == '(') {
                ++at_;
                const scaling::Rational p = rational();
                expect(')');
                return p;
            }
            return decimal();
        }
        const bool sign = text_[at_] == '-' || text_[at_] == '+';
        const std::size_t digit = at_ + (sign ? 1 : 0);
        return digit < text_.size() && is_digit(text_[digit]) ? scaling::Rational(integer())
                                                              : scaling::Rational(1);
    }

    scaling::Rational rational() {
        const scaling::Rational numerator = decimal();
        if (at_ == text_.size() || text_[at_] != '/') return numerator;
        ++at_;
        const int denominator = integer();
        if (denominator == 0) throw UnitProblem("/0", "must have powers other than /0");
        return numerator / denominator;
    }

    scaling::Rational decimal() {
        const bool negative = at_ < text_.size() && text_[at_] == '-';
        scaling::Rational value(integer());
        if (at_ + 1 < text_.size() && text_[at_] == '.' && is_digit(text_[at_ + 1])) {
            ++at_;
            int scale = 1;
            const std::size_t from = at_;
            while (at_ < text_.size() && is_digit(text_[at_]) && at_ - from < 4) {
                scale *= 10;
                value += scaling::Rational((negative ? -1 : 1) * (text_[at_] - '0'), scale);
                ++at_;
            }
        }
        return value;
    }

    int integer() {
        bool negative = false;
        if (at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+'))
            negative = text_[at_++] == '-';
        const std::size_t from = at_;
        int value = 0;
        while (at_ < text_.size() && is_digit(text_[at_]) && at_ - from < 2)
            value = 10 * value + (text_[at_++] - '0');
        if (at_ == from) throw UnitProblem(text_.substr(from), "must have a number as power");
        return negative ? -value : value;
    }

    bool skip_spaces() {
        const std::size_t from = at_;
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
        return at_ != from;
    }
    bool divides() const {
        const std::string_view rest = std::string_view(text_).substr(at_);
        return rest.starts_with('/') || rest.starts_with("per ");
    }
    void expect(char c) {
        skip_spaces();
        if (at_ == text_.size() || text_[at_] != c)
            throw UnitProblem(text_, std::string("must have a ") + c + " more");
        ++at_;
    }

    const std::string& text_;
    std::size_t at_ = 0;
};

}  // namespace

std::string normalise(const std::string& text) {
    std::string plain;
    bool raised = false;
    for (std::size_t i = 0; i < text.size();) {
        const std::string_view rest = std::string_view(text).substr(i);
        bool found = false;
        for (const auto& [sign, digit] : superscripts) {
            if (!rest.starts_with(sign)) continue;
            if (!raised) plain += '^';
            plain += digit;
            i += sign.size();
            raised = found = true;
            break;
        }
        if (found) continue;
        raised = false;
        for (const auto& [sign, replacement] : spellings) {
            if (!rest.starts_with(sign)) continue;
            plain += replacement;
            i += sign.size();
            found = true;
            break;
        }
        if (!found) plain += text[i++];
    }
    const std::size_t first = plain.find_first_not_of(" \r\n");
    if (first == std::string::npos) return "";
    return plain.substr(first, plain.find_last_not_of(" \r\n") - first + 1);
}

Unit parse_normalised_unit(const std::string& text) { return Parser(text).whole(); }

}  // namespace cases
