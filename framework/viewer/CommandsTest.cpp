#include "viewer/Commands.h"

#include <set>

#include <doctest/doctest.h>

#include "viewer/LibraryBuild.h"
#include "viewer/Supervisor.h"

using namespace radlab;

TEST_CASE("every command has one key, no key has two, and each can be given in upper case") {
    std::set<Command> commands;
    std::set<std::pair<char, Key>> keys;
    for (const Binding& binding : bindings()) {
        CHECK(commands.insert(binding.command).second);
        CHECK(keys.insert({binding.character, binding.key}).second);
        if (binding.character >= 'a' && binding.character <= 'z')
            CHECK(commandOf(static_cast<char>(binding.character - 'a' + 'A')) == binding.command);
        if (binding.key != Key::none) CHECK(commandOf(binding.key) == binding.command);
    }
    CHECK(commands.size() == static_cast<std::size_t>(Command::quit) + 1);
    CHECK(!commandOf('j'));
    CHECK(!commandOf('\0'));
    CHECK(!commandOf(Key::none));
}

TEST_CASE("the first error of a build is shown with its line, from the project on") {
    const std::string output =
        "[1/2] Building CXX object\nFAILED: x.o\n/usr/bin/c++ -DX /p/exercises/ProgRef.cpp\n"
        "/p/exercises/ProgRef.cpp:17:5: error: 'x' was not declared\n   17 |     x;\n      |     ^\n"
        "/p/exercises/ProgRef.cpp:18:5: error: more\nninja: build stopped\n";
    const std::string shown = firstErrorIn(output, "/p/");
    CHECK(shown.rfind("exercises/ProgRef.cpp:17:5: error: 'x' was not declared", 0) == 0);
    CHECK(shown.find(":18:") == std::string::npos);
    CHECK(firstErrorIn("no such compiler", "/p/") == "no such compiler");
}

TEST_CASE("a crash is told under the function's name with the stage") {
    CHECK(crashMessage(Running::calcFF, "crashed").find("calcFF crashed") == 0);
    CHECK(crashMessage(Running::calcFF, "crashed").find("stage 6") != std::string::npos);
    CHECK(crashMessage(Running::loading, "crashed").find("global variables") != std::string::npos);
    CHECK(stageOf("distributeEnergy") == 3);
    CHECK(stageOf("main") == 0);
}
