#pragma once

#include <string>
#include <vector>

namespace radlab {

/// Tells the user of something that was passed over: one line on stderr, `warning: …`.
///
/// For what is wrong, throw an Error instead.
void warn(const std::string& text);

/// Collects the warnings of this thread while it lives, instead of printing them.
class WarningCapture {
public:
    WarningCapture();
    ~WarningCapture();
    WarningCapture(const WarningCapture&) = delete;
    WarningCapture& operator=(const WarningCapture&) = delete;

    std::vector<std::string> texts;

private:
    WarningCapture* outer;
};

}  // namespace radlab
