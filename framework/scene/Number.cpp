#include "scene/Number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <limits>
#include <locale>
#include <sstream>

#include "base/Interrupts.h"

namespace radlab {

namespace {

constexpr int limitOfExponent = 60;   // far outside the range of a float, well inside that of a double
constexpr int digitsOfMantissa = 18;  // as many as surely fit 64 bits
constexpr int enoughExponent = 100000;

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Takes the text apart from the left.
class NumberScanner {
public:
    explicit NumberScanner(std::string_view text) : rest(text) {}

    std::optional<double> scan() {
        const bool negative = sign();
        digits(0);
        if (take('.')) digits(-1);
        if (!sawDigit || !scanExponent() || !rest.empty()) return std::nullopt;
        return negative ? -value() : value();
    }

private:
    bool take(char wanted) {
        if (rest.empty() || rest.front() != wanted) return false;
        rest.remove_prefix(1);
        return true;
    }

    bool sign() { return take('-') || (take('+'), false); }

    /// Adds digits to the mantissa; each one moves the exponent by `step`, and those that no longer fit by one more.
    void digits(int step) {
        for (; !rest.empty() && isDigit(rest.front()); rest.remove_prefix(1)) {
            sawDigit = true;
            const int digit = rest.front() - '0';
            const bool fits = count < digitsOfMantissa;
            if (fits) mantissa = mantissa * 10 + static_cast<std::uint64_t>(digit);
            if (fits && mantissa > 0) ++count;
            exponent += step + (fits ? 0 : 1);
        }
    }

    bool scanExponent() {
        if (!take('e') && !take('E')) return true;
        const bool negative = sign();
        if (rest.empty() || !isDigit(rest.front())) return false;
        int written = 0;
        for (; !rest.empty() && isDigit(rest.front()); rest.remove_prefix(1))
            written = std::min(enoughExponent, written * 10 + (rest.front() - '0'));
        exponent += negative ? -written : written;
        return true;
    }

    double value() const {
        if (mantissa == 0 || exponent + count < -limitOfExponent) return 0.0;
        if (exponent + count > limitOfExponent) return std::numeric_limits<double>::infinity();
        double power = 1.0;
        for (long long i = 0; i < (exponent < 0 ? -exponent : exponent); ++i) power *= 10.0;
        // Dividing keeps 0.1 and its kin exact: powers of ten are exact up to 1e22, their inverses never.
        return exponent < 0 ? static_cast<double>(mantissa) / power : static_cast<double>(mantissa) * power;
    }

    std::string_view rest;
    std::uint64_t mantissa = 0;
    int count = 0;
    long long exponent = 0;
    bool sawDigit = false;
};

bool isSeparator(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ','; }

}  // namespace

std::optional<double> parseNumber(std::string_view text) { return NumberScanner(text).scan(); }

std::optional<int> parseWhole(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    int value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::vector<std::string_view> splitList(std::string_view text) {
    std::vector<std::string_view> pieces;
    for (std::size_t at = 0; at < text.size();) {
        Interrupts::check();
        std::size_t end = at;
        while (end < text.size() && !isSeparator(text[end])) ++end;
        if (end > at) pieces.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return pieces;
}

std::string numberText(double value) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(7);
    text << value;
    return text.str();
}

}  // namespace radlab
