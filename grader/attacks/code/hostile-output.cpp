// Prints what a terminal, a browser, a spreadsheet or a CI service might obey.
static void attack() {
    std::printf(
        "\033[2J\033]0;title\a\r\n::error::forged\n=HYPERLINK(\"http://x\")\n<script>alert(1)</script>\n</"
        "pre>{{score}}\xff\n");
    std::fflush(stdout);
    throw std::runtime_error("\033[31m<img src=x onerror=alert(1)>\n=cmd|' /C calc'!A0\nscore: 100/100");
}
