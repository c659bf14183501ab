# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Links of the documents lead to files and headings that are there, each model
page is in the index and has its parts, each annotated dictionary is named by a
page, and doxygen can read the headers. The folder of the project is the
argument."""

import os
import re
import subprocess
import sys

from caseTools import verdict


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def prose(text):
    """Without blocks and words of code, in which brackets are no links."""
    text = re.sub(r"(?ms)^```.*?^```$", "", text)
    text = re.sub(r"(?m)^    .*$", "", text)
    return re.sub(r"`[^`\n]*`", "", text)


def anchors(text):
    """The headings as GitHub names them."""
    found = set()
    for heading in re.findall(r"(?m)^#+ (.*)$",
                              re.sub(r"(?ms)^```.*?^```$", "", text)):
        name = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
        found.add(name)
    return found


def documents(root):
    yield from (n for n in os.listdir(root) if n.endswith(".md"))
    for top in ("doc", "tutorials", "tests"):
        for folder, _, names in os.walk(os.path.join(root, top)):
            for name in names:
                if name.endswith(".md"):
                    yield os.path.relpath(os.path.join(folder, name), root)


def broken(root):
    """Links that lead nowhere, and how many there are."""
    bad, count = [], 0
    for name in documents(root):
        text = prose(read(os.path.join(root, name)))
        links = re.findall(r"\]\(([^)\s]+)\)", text)
        links += re.findall(r'<img src="([^"]+)"', text)
        for link in links:
            if re.match(r"https?:|mailto:", link):
                continue
            count += 1
            path, _, anchor = link.partition("#")
            target = os.path.normpath(os.path.join(
                root, os.path.dirname(name), path)) if path else (
                    os.path.join(root, name))
            if not os.path.exists(target) or (
                    anchor and anchor not in anchors(read(target))):
                bad.append(f"{name}: {link}")
    return bad, count


def tables(root):
    """Lines of headers, as doxygen gets them, that are rows of a table without
    a title or of another length than its title, or a command that doxygen does
    not know; and how many tables there are."""
    bad, count = [], 0
    for top in "src", "applications":
        for folder, folders, names in os.walk(os.path.join(root, top)):
            folders[:] = [f for f in folders if f not in ("lnInclude", "Make")]
            for name in names:
                if not name.endswith(".H"):
                    continue
                text = subprocess.run(
                    [os.path.join(root, "doc/doxygenFilter"),
                     os.path.join(folder, name)], stdout=subprocess.PIPE,
                    text=True, check=True).stdout
                text = text[:text.find("*/")]
                bad += [f"{name}: {command}" for command in
                        re.findall(r"\\+(?:end)?table\b", text)]
                for table in re.findall(r"(?m)(?:^\|[ -].*\n)+", text):
                    count += 1
                    bars = {row.count("|") for row in table.splitlines()}
                    rule = table.splitlines()[1:2]
                    if len(bars) > 1 or not rule or set(rule[0]) != set("|-"):
                        bad.append(f"{name}: {table[:60]}")
    return bad, count


def main():
    root = sys.argv[1]
    bad, count = broken(root)
    verdict("linksLead", not bad and count > 50, f"{count} links; {bad}")

    bad, count = tables(root)
    verdict("headersReadable", not bad and count > 50, f"{count} tables; {bad}")

    index = read(os.path.join(root, "doc/models.md"))
    folder = os.path.join(root, "doc/models")
    pages = {name: read(os.path.join(folder, name))
             for name in sorted(os.listdir(folder)) if name.endswith(".md")}
    missing = [n for n in pages if f"(models/{n})" not in index]
    verdict("modelPagesIndexed", pages and not missing,
            f"{len(pages)} pages; not in doc/models.md: {missing}")

    # Its name, what it computes, its parts; limits and sources come last
    poor = []
    for name, text in pages.items():
        parts = re.findall(r"(?m)^## (.*)$", text)
        if (not text.startswith("# ") or "Limits" not in parts[-2:]
                or len(text.split("\n\n")[1]) < 60):
            poor.append(name)
    verdict("modelPagesComplete", not poor, f"poor: {poor}")

    said = "".join(pages.values())
    missing = [n for n in os.listdir(os.path.join(
        root, "etc/caseDicts/annotated")) if f"{n}`" not in said]
    verdict("modelsDescribed", not missing,
            f"annotated dictionaries in no page of doc/models: {missing}")


if __name__ == "__main__":
    main()
