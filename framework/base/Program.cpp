#include "base/Program.h"

#include <exception>
#include <iostream>

#include "base/Error.h"
#include "base/Interrupts.h"

namespace radlab {

int runProgram(const std::function<int()>& body) {
    try {
        return body();
    } catch (const Error& error) {
        std::cerr << "error: " << error.what() << '\n';
        return 2;
    } catch (const Interrupted&) {
        std::cerr << "interrupted: nothing that is worth keeping was made yet, so nothing was written\n";
        return 130;
    } catch (const NotImplemented& stub) {
        std::cerr << "not started: " << stub.what() << "; write it in exercises/ProgRef.cpp\n";
        return 2;
    } catch (const std::exception& fault) {
        std::cerr << "internal error: " << fault.what() << '\n';
        return 3;
    } catch (...) {
        std::cerr << "internal error: something was thrown that is no exception\n";
        return 3;
    }
}

}  // namespace radlab
