#!/usr/bin/env python3
"""A zip file of a folder that depends on nothing but its contents: sorted, with one time for all entries.

    python3 release/zip.py FOLDER NAME FILE.zip SECONDS      packs FOLDER/NAME with this time since 1970
"""

import sys
import time
import zipfile
from pathlib import Path


def main():
    folder, name, file, seconds = sys.argv[1:]
    moment = time.gmtime(int(seconds))[:6]
    with zipfile.ZipFile(file, "w") as archive:
        for path in sorted(Path(folder, name).rglob("*")):
            if path.is_file():
                entry = zipfile.ZipInfo(path.relative_to(folder).as_posix(), moment)
                entry.compress_type = zipfile.ZIP_DEFLATED
                entry.external_attr = 0o100644 << 16
                archive.writestr(entry, path.read_bytes(), compresslevel=9)


if __name__ == "__main__":
    main()
