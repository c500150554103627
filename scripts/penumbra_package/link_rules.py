"""Links and pictures of shipped pages refer to shipped files, so that they work in the installed package."""
import posixpath
import re
from urllib.parse import unquote

from .problem import at_offset

CODE = re.compile(r"^(```|~~~).*?^\1[ \t]*$|`[^`\n]*`", re.DOTALL | re.MULTILINE)
LINK = re.compile(r'\]\(\s*<?([^)\s>]+)>?(?:\s+"[^"]*")?\s*\)')
OF_THE_WEB = re.compile(r"[A-Za-z][A-Za-z0-9+.-]*:|#")


def targets(package, page):
    """The targets of the page's links and pictures below the package's root: as written, the path, the location."""
    text = package.text(page)
    prose = CODE.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)
    for match in LINK.finditer(prose):
        if not OF_THE_WEB.match(match[1]):
            path = posixpath.normpath(posixpath.join(posixpath.dirname(page), unquote(match[1].split("#")[0])))
            yield match[1], path, match.start(1)


def check(package):
    for page in package.ending(".md"):
        for written, target, offset in targets(package, page):
            if target not in package.files | package.folders:
                yield at_offset(page, package.text(page), offset, f"{written} is not in the package: correct the link, "
                                                                  "or name the file in 'files' of package.json")
