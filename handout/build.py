#!/usr/bin/env python3
"""Builds the handout: out/handout/index.html with a page for each chapter, and radlab.pdf.

  ./radlab handout            the pages and the PDF
  ./radlab handout --figures  makes all figures and numbers anew from the scenes, some minutes (or steps of it: --figures race)
  ./radlab handout --api      the documentation of the source: out/handout/api/index.html
"""
import html
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
OUT = ROOT / "out/handout"


def fail(text):
    sys.exit(f"radlab: handout: {text}")


def chapters():
    return sorted(HERE.glob("[0-9][0-9]-*.md"))


def filled(text, numbers, name):
    """The text with the numbers in the places of {{name}}."""
    def value(match):
        if match.group(1) not in numbers:
            fail(f"{name}: found {match.group(0)}, expected a number that handout/figures.json has")
        return str(numbers[match.group(1)])
    return re.sub(r"\{\{(\w+)\}\}", value, text)


def source():
    numbers = json.loads((HERE / "figures.json").read_text())
    return "\n\n".join(filled(file.read_text(), numbers, file.name) for file in chapters())


def pandoc(text):
    """All chapters as one HTML text: a section of level 1 for each."""
    if not shutil.which("pandoc"):
        fail("pandoc was not found; on Debian: apt-get install pandoc")
    command = ["pandoc", "--from=markdown", "--to=html5", "--mathml", "--citeproc",
               "--section-divs", "--number-sections", "--no-highlight", "--wrap=none", "--fail-if-warnings",
               f"--bibliography={ROOT / 'resources/references.bib'}", "--metadata=link-citations:true"]
    done = subprocess.run(command, input=text, text=True, stdout=subprocess.PIPE)
    if done.returncode:
        fail("pandoc failed: correct what it says above and run the same command again")
    return done.stdout


def set_better(body):
    """Equations with brackets of the line's height, functions without wide gaps, no full stop alone on the next line; flags in one piece."""
    body = re.sub(r'<mo stretchy="true"( form="p\w+fix")>([()])</mo>', r'<mo stretchy="false"\1>\2</mo>', body)
    body = re.sub(r'(<math display="inline"(?:(?!</math>).)*</math>)([.,;:?!)]+)', r'<span class="whole">\1\2</span>', body, flags=re.DOTALL)
    body = re.sub(r"<mo>(cos|sin|max)</mo>", r'<mspace width="0.1em"/><mi>\1</mi><mspace width="0.15em"/>', body)
    return re.sub(r"<code>([^<]*)</code>", lambda span: re.sub(r"(?<![^\s>])(--?[a-z][\w-]*)", r'<span class="whole">\1</span>', span.group(0)),
                  body)


def figures_in(body):
    """Figures with their numbers; drawings stand in the page, so that its colours reach them; for phones, the narrow form of a plot."""
    count = iter(range(1, 1000))
    body = re.sub(r"<figcaption[^>]*>", lambda _: f"<figcaption><b>Figure {next(count)}.</b> ", body)

    def drawing(match):
        return re.sub(r"^<\?xml.*?\?>\s*|<!DOCTYPE.*?>\s*", "", (HERE / match.group(1)).read_text(), flags=re.DOTALL)
    body = re.sub(r'<img src="(figures/(?!plot-)[^"]+\.svg)"[^>]*/>', drawing, body)
    body = re.sub(r'<img src="([^"]+)"', r'<img loading="lazy" src="\1"', body)

    def narrow(match):
        other = match.group(1).replace(".svg", "-narrow.svg")
        if not (HERE / other).exists():
            return match.group(0)
        return f'<picture><source media="screen and (max-width: 480px)" srcset="{other}" />{match.group(0)}</picture>'
    body = re.sub(r'<img [^>]*src="(figures/plot-[^"]+\.svg)"[^>]*/>', narrow, body)
    return re.sub(r"<table>(.*?)</table>", r'<div class="wide"><table>\1</table></div>', body, flags=re.DOTALL)


def sections_of(body):
    """(id, number, title, html) of each chapter."""
    found = []
    for part in re.split(r'(?=<section id="[^"]+" class="level1)', body)[1:]:
        head = re.match(r'<section id="([^"]+)".*?<h1[^>]*>(?:<span class="header-section-number">(\d+)</span>)?(.*?)</h1>',
                        part, re.DOTALL)
        found.append((head.group(1), head.group(2), re.sub(r"<[^>]+>", "", head.group(3)).strip(), part))
    return found


def contents(sections, here=""):
    rows = [f'<li{" class=here" if key == here else ""}><a href="{page_of(key)}">{title}</a></li>'
            for key, _, title, _ in sections]
    return "<ol start=0>" + "".join(rows) + "</ol>"


def page_of(key):
    return f"{key}.html"


def linked(part, home):
    """Links into other chapters lead to their pages."""
    return re.sub(r'href="#([^"]+)"', lambda m: f'href="{page_of(home.get(m.group(1), m.group(1)))}#{m.group(1)}"', part)


def neighbours(sections, place):
    def link(at, words):
        if not 0 <= at < len(sections):
            return "<span></span>"
        return f'<a href="{page_of(sections[at][0])}">{words.format(sections[at][2])}</a>'
    return f'<nav class="turn">{link(place - 1, "← {}")}{link(place + 1, "{} →")}</nav>'


def write_pages(sections):
    template = (HERE / "page.html").read_text()
    home = {key: chapter for chapter, _, _, part in sections for key in re.findall(r'id="([^"]+)"', part)}

    def page(title, body, here):
        text = template
        for mark, value in {"TITLE": html.escape(title), "CONTENTS": contents(sections, here), "BODY": body}.items():
            text = text.replace(f"<!--{mark}-->", value)
        return text
    for place, (key, _, title, part) in enumerate(sections):
        body = linked(part, home) + neighbours(sections, place)
        (OUT / page_of(key)).write_text(page(f"{title} · radlab", body, key))
    cover = (HERE / "cover.html").read_text()
    (OUT / "index.html").write_text(page("radlab: radiosity, step by step", cover + contents(sections), ""))


def write_pdf(sections):
    browser = shutil.which("chromium") or shutil.which("chromium-browser")
    if not browser:
        fail("chromium was not found, so there is no PDF; on Debian: apt-get install chromium")
    rows = "".join(f'<li><a href="#{key}">{title}</a></li>' for key, _, title, _ in sections)
    body = (HERE / "cover.html").read_text() + f'<nav class="toc"><ol start=0>{rows}</ol></nav>' + "".join(s[3] for s in sections)
    body = body.replace('loading="lazy" ', "")
    style = '<link rel="stylesheet" href="style.css">'
    (OUT / "print.html").write_text(f'<!doctype html><html lang="en" class="print"><meta charset="utf-8">'
                                    f"<title>radlab: radiosity, step by step</title>{style}<main>{body}</main></html>")
    command = [browser, "--headless", "--no-sandbox", "--disable-gpu", "--no-pdf-header-footer", "--allow-file-access-from-files",
               f"--print-to-pdf={OUT / 'radlab.pdf'}", (OUT / "print.html").as_uri()]
    done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode or not (OUT / "radlab.pdf").exists():
        fail(f"chromium made no PDF: {done.stderr[-300:]}")
    (OUT / "print.html").unlink()


def build():
    OUT.mkdir(parents=True, exist_ok=True)
    sections = sections_of(figures_in(set_better(pandoc(source()))))
    shutil.copytree(HERE / "figures", OUT / "figures", dirs_exist_ok=True)
    shutil.copy(HERE / "style.css", OUT)
    write_pages(sections)
    write_pdf(sections)
    print(f"radlab: wrote {OUT / 'radlab.pdf'}\nradlab: open {OUT / 'index.html'}")


def api():
    if not shutil.which("doxygen"):
        fail("doxygen was not found; on Debian: apt-get install doxygen")
    (OUT / "api").mkdir(parents=True, exist_ok=True)
    if subprocess.run(["doxygen", HERE / "Doxyfile"], cwd=ROOT).returncode:
        fail("doxygen warned: mend the comments that it names above and run the same command again")
    print(f"radlab: open {OUT / 'api/index.html'}")


def main():
    words = sys.argv[1:]
    if words in (["--help"], ["-h"]):
        print(__doc__.strip())
    elif words == ["--api"]:
        api()
    elif words[:1] == ["--figures"] and len(words) > 1:
        sys.exit(subprocess.run([HERE / "figures.py", *words[1:]]).returncode)
    elif not words:
        build()
    else:
        fail(f"found '{' '.join(words)}', expected nothing, --figures or --api")


if __name__ == "__main__":
    main()
