"""Keeps what became of robots in a file, so that a campaign that was stopped can go on."""

import hashlib
import pathlib
import pickle
import shutil


class Another(Exception):
    """The file is of a campaign with other arguments, or of something else."""


class State:
    """Results of a campaign in the order of its robots, as far as it came. Without a path nothing is kept.

    The file is only added to. What was being written when the campaign was stopped is not complete: it is cut off, and that
    robot attacked once more. It is read with pickle, so it has to be a file that a campaign wrote here.
    """

    def __init__(self, path, arguments):
        """arguments: what the results depend on; compared with those of the file.

        Raises Another where they differ.
        """
        self.path = None if path is None else pathlib.Path(path)
        self.results = []
        if self.path is None:
            return
        if self.path.exists():
            self.load(arguments)
        else:
            self.append(arguments)

    def load(self, arguments):
        with self.path.open("r+b") as file:
            if read_one(file) != arguments:
                raise Another(f"'{self.path}' was not left by a campaign with the same arguments")
            complete = file.tell()
            while (result := read_one(file)) is not None:
                self.results.append(result)
                complete = file.tell()
            file.truncate(complete)

    def append(self, what):
        if self.path is not None:
            with self.path.open("ab") as file:
                pickle.dump(what, file)


def read_one(file):
    """None at the end, and where the rest is not complete."""
    try:
        return pickle.load(file)
    except (EOFError, pickle.UnpicklingError, ValueError, IndexError, KeyError):
        return None


def digest_of(program):
    """Of the program under attack, by name or path: results of another one are none of this."""
    found = shutil.which(program)
    return None if found is None else hashlib.sha256(pathlib.Path(found).read_bytes()).hexdigest()
