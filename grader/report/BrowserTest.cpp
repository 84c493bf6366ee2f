// The pages in a real browser: Chromium without a window, where there is one.

#include <cstdlib>

#include <doctest/doctest.h>

#include "base/TestFolder.h"
#include "base/TestSkip.h"
#include "base/WholeFile.h"
#include "grader/report/ClassPage.h"
#include "grader/report/PageTestHelp.h"
#include "grader/report/SampleClass.h"
#include "grader/report/StudentPage.h"

#if __has_include(<sodium.h>)

using namespace radlab::grader;
using namespace radlab::grader::test;

namespace {

// Markup that would change the title of the page, if it were taken for markup.
constexpr const char* attack =
    "<img src=x onerror=\"document.title='broken'\"><script>document.title='broken'</script><svg "
    "onload=\"document.title='broken'\">\"></a>";

class Browser {
public:
    // The page as it stands when it is loaded, its scripts run; nothing where no browser starts.
    std::string load(const std::string& page, const std::string& view = "") {
        radlab::writeFile(folder / "page.html", page);
        run("'file://" + path("page.html") + view + "'");
        std::string dump = radlab::readFile(folder / "dump");
        if (!dump.empty()) return dump;
        run("about:blank");  // tells a browser that cannot start from a page that it cannot load
        REQUIRE(radlab::readFile(folder / "dump").empty());
        radlab::test::skipped("no chromium starts here: " + radlab::readFile(folder / "log").substr(0, 300));
        return "";
    }

    std::string log() const { return radlab::readFile(folder / "log"); }

private:
    std::string path(const std::string& name) const { return (folder / name).string(); }

    void run(const std::string& address) const {
        const std::string command = "HOME='" + path("home") +
                                    "' timeout 600 chromium --headless --no-sandbox --disable-gpu "
                                    "--disable-dev-shm-usage --no-first-run --user-data-dir='" +
                                    path("profile") + "' --enable-logging=stderr --dump-dom " + address + " >'" +
                                    path("dump") + "' 2>'" + path("log") + "'";
        [[maybe_unused]] const int code = std::system(command.c_str());
    }

    radlab::test::Folder folder;
};

std::vector<std::string> shownRows(const std::string& dump) {
    std::vector<std::string> rows;
    for (std::size_t at = dump.find("<tr data-status="); at != std::string::npos;
         at = dump.find("<tr data-status=", at + 1)) {
        const std::size_t end = dump.find('>', at), link = dump.find("students/student-", at);
        if (!contains(dump.substr(at, end - at), "hidden")) rows.push_back(dump.substr(link + 17, 2));
    }
    return rows;
}

ClassInfo untitledInfo() { return {"Radiosity", "", "", {}, {}}; }

}  // namespace

TEST_CASE("browser: the class page sorts and filters by its address, whatever students are called") {
    Browser browser;
    const std::string page = classPage(untitledInfo(), classSaying(attack + hostileText()));
    const std::string dump = browser.load(page, "#sort=total&status=graded");
    if (dump.empty()) return;
    CHECK(shownRows(dump) == std::vector<std::string>{"02", "01"});
    CHECK(contains(dump, ">2 of 6 students</output>"));
    CHECK(contains(dump, "aria-sort=\"ascending\"><button type=\"button\">Total</button>"));
    CHECK(contains(dump, "<title>radlab: Radiosity</title>"));
    CHECK(countOf(dump, "<script") == 1);
    CHECK(countOf(dump, "<img") == 0);
    CHECK_FALSE(contains(browser.log(), "Content Security Policy"));
    CHECK_FALSE(contains(browser.log(), "Uncaught"));
}

TEST_CASE("browser: a search finds names and mistakes") {
    Browser browser;
    const std::string dump = browser.load(classPage(untitledInfo(), smallClass()), "#q=Missing-inverse%20STUDENT");
    if (dump.empty()) return;
    CHECK(shownRows(dump) == std::vector<std::string>{"02"});
    CHECK_FALSE(contains(browser.log(), "Uncaught"));
}

TEST_CASE("browser: an address with markup in it, or of nothing that there is, does no harm") {
    Browser browser;
    const std::string view = "#q=%3Cimg%20src%3Dx%20onerror%3Ddocument.title%3D1%3E&sort=%22&down=1&status=x";
    const std::string dump = browser.load(classPage(untitledInfo(), smallClass()), view);
    if (dump.empty()) return;
    CHECK(shownRows(dump).empty());
    CHECK(contains(dump, "<title>radlab: Radiosity</title>"));
    CHECK_FALSE(contains(dump, "aria-sort=\""));
    CHECK_FALSE(contains(browser.log(), "Uncaught"));
}

TEST_CASE("browser: a page into which a script got all the same does not run it") {
    Browser browser;
    std::string page = classPage(untitledInfo(), smallClass());
    page.insert(page.find("</main>"), attack);
    const std::string dump = browser.load(page);
    if (dump.empty()) return;
    CHECK(countOf(dump, "<script") == 2);
    CHECK(contains(dump, "<title>radlab: Radiosity</title>"));
    CHECK(contains(browser.log(), "Content Security Policy"));
    CHECK(contains(dump, ">6 students</output>"));
}

TEST_CASE("browser: a student's page shows its pictures, and nothing on it is refused") {
    // A PNG of one pixel.
    const std::string png(
        "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x08\6\0\0\0\x1f\x15\xc4\x89\0\0\0\rIDATx\x9c"
        "c\xf8\xcf\xc0\xf0\x1f\0\5\0\1\xff\x56\xc7\x2f\r\0\0\0\0IEND\xae\x42\x60\x82",
        70);
    const CheckPicture picture{"calcAnalyticalFF", "ff.facing", "a room", 0.1, 0.01, {{"yours", png, 1, 1}}};
    Browser browser;
    const std::string dump = browser.load(studentPage(classSaying(attack + hostileText())[1], {picture}));
    if (dump.empty()) return;
    CHECK(countOf(dump, "<script") == 0);
    CHECK(countOf(dump, "<img ") == 1);
    CHECK_FALSE(contains(dump, "<title>broken"));
    CHECK_FALSE(contains(browser.log(), "Content Security Policy"));
}

#endif
