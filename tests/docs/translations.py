#!/usr/bin/env python3
"""Holds the Chinese pages to the English ones they translate.

usage: translations.py SOURCE

A Chinese page names the commit whose English page it says the same as, and that page's Git blob:

    <!-- translation of README.md at <commit>, blob <blob> -->

The blob is the hash of the file alone, so that the English page can be held to it without history, in a shallow clone or an
unpacked archive as well; the commit is for people (git diff <commit> -- README.md shows what has to be translated) and is held to
the blob where Git knows it. Besides, headings, blocks of code, links and pictures of the two pages are the same, in order.
"""
import hashlib
import pathlib
import posixpath
import re
import subprocess
import sys

PAIRS = {"README.md": "README.zh-CN.md", "docs/tutorial.md": "docs/zh/tutorial.md"}
TERMS = "docs/zh/terms.md"
STAMP = re.compile(r"^<!-- translation of (\S+) at ([0-9a-f]{40}), blob ([0-9a-f]{40}) -->$", re.M)


def blob_of(data):
    return hashlib.sha1(b"blob %d\0" % len(data) + data).hexdigest()


def slug(heading):
    """What GitHub makes of a heading for links."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


class Page:
    """What a translation keeps."""

    def __init__(self, source, name):
        self.name = name
        self.data = (source / name).read_bytes()
        self.headings, self.blocks = [], []
        self.read(self.data.decode())

    def read(self, text):
        block, prose = None, ""
        for line in text.splitlines():
            if line.startswith("```"):
                if block is None:
                    block = [line]
                else:
                    self.blocks.append(block)
                    block = None
            elif block is not None:
                block.append(without_comment(line) if block[0] == "```sh" else line)
            elif line.startswith("#"):
                self.headings.append((line.split(" ")[0], slug(line.lstrip("#"))))
            elif line.startswith(("| <pre>", "<!-- file:")):
                self.blocks.append([line])
            else:
                prose += line + "\n"
        self.links = re.findall(r"(!?)\[[^\]]*\]\(([^)]*)\)", prose)

    def target(self, link):
        """Where a link leads, the same for both languages: pictures with !, headings of translated pages by number."""
        mark, target = link
        if target.startswith("http"):
            return mark + target
        path, _, anchor = target.partition("#")
        path = posixpath.normpath(posixpath.join(posixpath.dirname(self.name), path)) if path else self.name
        english = {chinese: english for english, chinese in PAIRS.items()}.get(path, path)
        if english in PAIRS and anchor:
            slugs = [heading for _, heading in pages[path].headings]
            anchor = slugs.index(anchor) if anchor in slugs else f"no heading '{anchor}'"
        return f"{mark}{english}#{anchor}"

    def targets(self):
        return [target for target in map(self.target, self.links) if target != TERMS + "#"]


def without_comment(line):
    """A line of a shell, whose comment is translated."""
    return re.sub(r"\s+#.*", "", line)


def difference(what, english, chinese):
    if english == chinese:
        return []
    for number, (one, other) in enumerate(zip(english, chinese), 1):
        if one != other:
            return [f"{what} {number} is {other!r}, in English {one!r}"]
    return [f"{len(chinese)} x {what}, in English {len(english)}"]


def stamp_mistakes(source, english, chinese):
    found = STAMP.search(chinese.data.decode())
    if not found or found.group(1) != english.name:
        return [f"no line <!-- translation of {english.name} at COMMIT, blob BLOB -->"]
    commit, blob = found.group(2), found.group(3)
    mistakes = []
    if blob != blob_of(english.data):
        mistakes.append(f"{english.name} has changed since. Translate what 'git diff {commit} -- {english.name}' shows, then name "
                        f"the commit that changed it and blob {blob_of(english.data)}")
    known = subprocess.run(["git", "-C", source, "rev-parse", "-q", "--verify", f"{commit}:{english.name}"],
                           capture_output=True, text=True, check=False)
    if known.returncode == 0 and known.stdout.strip() != blob:
        mistakes.append(f"commit {commit} has another {english.name}: blob {known.stdout.strip()}")
    return mistakes


def mistakes_of(source, english, chinese):
    mistakes = stamp_mistakes(source, english, chinese)
    mistakes += difference("heading", [level for level, _ in english.headings], [level for level, _ in chinese.headings])
    mistakes += difference("block of code", english.blocks, chinese.blocks)
    mistakes += difference("link", english.targets(), chinese.targets())
    return [f"{chinese.name}: {mistake}" for mistake in mistakes]


if __name__ == "__main__":
    root = pathlib.Path(sys.argv[1])
    pages = {name: Page(root, name) for pair in PAIRS.items() for name in pair}
    all_mistakes = [m for english, chinese in PAIRS.items() for m in mistakes_of(root, pages[english], pages[chinese])]
    for text in all_mistakes:
        print(text)
    print(f"{len(PAIRS)} pages, {len(all_mistakes)} mistakes")
    sys.exit(1 if all_mistakes else 0)
