#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace radlab {

/// A place in a text file: line numbers start at 1, and 0 means the file as a whole.
struct Location {
    std::string file;
    int line = 0;
};

/// Bad input: a file, a flag or a submission that cannot be used.
///
/// The text reads `file:line: what is wrong, what was found, what was expected`. Only main catches it.
class Error : public std::runtime_error {
public:
    explicit Error(const std::string& what) : std::runtime_error(what) {}
    Error(const Location& where, const std::string& what) : std::runtime_error(prefix(where) + what), location(where) {}

    const Location& where() const { return location; }

private:
    static std::string prefix(const Location& where) {
        if (where.file.empty()) return "";
        return where.file + (where.line > 0 ? ":" + std::to_string(where.line) : "") + ": ";
    }

    Location location;
};

/// Thrown by a stub of the exercise that is not written yet.
class NotImplemented : public std::logic_error {
public:
    explicit NotImplemented(const std::string& function)
        : std::logic_error(function + " is not written yet"), name(function) {}

    const std::string& function() const { return name; }

private:
    std::string name;
};

namespace detail {

/// The outcome of a comparison together with its two sides, for RADLAB_CHECK.
struct Comparison {
    bool holds;
    std::string sides;
};

template <class Value>
void show(std::ostream& out, const Value& value) {
    if constexpr (requires { out << value; })
        out << value;
    else
        out << "(a value that cannot be shown)";
}

template <class Left>
struct LeftSide {
    const Left& left;

    template <class Right>
    Comparison compare(bool holds, const char* sign, const Right& right) const {
        if (holds) return {true, ""};
        std::ostringstream text;
        text.precision(9);
        show(text, left);
        text << ' ' << sign << ' ';
        show(text, right);
        return {false, text.str()};
    }
    template <class Right>
    Comparison operator<(const Right& right) const {
        return compare(left < right, "<", right);
    }
    template <class Right>
    Comparison operator>(const Right& right) const {
        return compare(left > right, ">", right);
    }
    template <class Right>
    Comparison operator<=(const Right& right) const {
        return compare(left <= right, "<=", right);
    }
    template <class Right>
    Comparison operator>=(const Right& right) const {
        return compare(left >= right, ">=", right);
    }
    template <class Right>
    Comparison operator==(const Right& right) const {
        return compare(left == right, "==", right);
    }
    template <class Right>
    Comparison operator!=(const Right& right) const {
        return compare(left != right, "!=", right);
    }
};

struct Decompose {
    template <class Left>
    LeftSide<Left> operator<<(const Left& left) const {
        return {left};
    }
};

template <class Left>
Comparison outcome(const LeftSide<Left>& side) {
    return {static_cast<bool>(side.left), "false"};
}
inline Comparison outcome(const Comparison& comparison) { return comparison; }

[[noreturn]] inline void brokenPromise(const char* file, int line, const char* expression, const std::string& sides) {
    throw std::logic_error(std::string(file) + ":" + std::to_string(line) + ": broken promise: " + expression + " (" +
                           sides + ")");
}

}  // namespace detail
}  // namespace radlab

// Clang warns of << before a comparison, which is what takes the comparison apart.
#ifdef __clang__
#define RADLAB_QUIETLY(...)                                                                                    \
    _Pragma("clang diagnostic push") _Pragma("clang diagnostic ignored \"-Woverloaded-shift-op-parentheses\"") \
        __VA_ARGS__ _Pragma("clang diagnostic pop")
#else
#define RADLAB_QUIETLY(...) __VA_ARGS__
#endif

/// A promise inside the program, checked in every build: RADLAB_CHECK(a < b) shows both values when it fails.
#define RADLAB_CHECK(...)                                                                            \
    do {                                                                                             \
        RADLAB_QUIETLY(const auto radlabOutcome =                                                    \
                           ::radlab::detail::outcome(::radlab::detail::Decompose() << __VA_ARGS__);) \
        if (!radlabOutcome.holds)                                                                    \
            ::radlab::detail::brokenPromise(__FILE__, __LINE__, #__VA_ARGS__, radlabOutcome.sides);  \
    } while (false)
