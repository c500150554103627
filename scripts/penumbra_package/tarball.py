"""The npm tarball of a package: the same files give the same bytes, whenever and by whomever it is made."""
import gzip
import io
import tarfile

from .package import NAME

# 1985-10-26 08:15 UTC, the time npm gives every file, as some programs take 1970 for "no time".
TIME = 499162500


def tarball_name(package):
    return f"{NAME}-{package.manifest()['version']}.tgz"


def tarball(package):
    packed = io.BytesIO()
    with gzip.GzipFile(filename="", mode="wb", fileobj=packed, mtime=TIME) as stream, \
            tarfile.open(mode="w", fileobj=stream, format=tarfile.PAX_FORMAT) as archive:
        for path in package.paths:
            content = package.bytes(path)
            entry = tarfile.TarInfo(f"package/{path}")
            entry.size, entry.mode, entry.mtime = len(content), 0o644, TIME
            archive.addfile(entry, io.BytesIO(content))
    return packed.getvalue()
