#include "base/Warning.h"

#include <iostream>

namespace radlab {

namespace {
thread_local WarningCapture* capture = nullptr;
}

void warn(const std::string& text) {
    if (capture)
        capture->texts.push_back(text);
    else
        std::cerr << "warning: " + text + "\n";
}

WarningCapture::WarningCapture() : outer(capture) { capture = this; }
WarningCapture::~WarningCapture() { capture = outer; }

}  // namespace radlab
