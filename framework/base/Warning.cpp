#include "base/Warning.h"

#include <iostream>

#include "base/ProgressBar.h"

namespace radlab {

namespace {
thread_local WarningCapture* capture = nullptr;

// On a terminal, a bar may stand on the line.
std::string lineStart() { return errorStreamIsTerminal() ? "\r\x1b[K" : ""; }

}  // namespace

void warn(const std::string& text) {
    if (capture)
        capture->texts.push_back(text);
    else
        std::cerr << lineStart() + "warning: " + text + "\n";
}

WarningCapture::WarningCapture() : outer(capture) { capture = this; }
WarningCapture::~WarningCapture() { capture = outer; }

}  // namespace radlab
