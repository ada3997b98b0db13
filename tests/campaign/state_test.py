"""A campaign that was stopped goes on where it was, whatever was being written then."""

import pathlib
import tempfile
import unittest

import state


class StateTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name) / "state"

    def kept(self, arguments=(1, 2)):
        return state.State(self.path, arguments)

    def test_goes_on_behind_what_was_kept(self):
        first = self.kept()
        first.append({"robot": 0})
        first.append({"robot": 1})
        again = self.kept()
        self.assertEqual(again.results, [{"robot": 0}, {"robot": 1}])
        again.append({"robot": 2})
        self.assertEqual([result["robot"] for result in self.kept().results], [0, 1, 2])

    def test_a_result_that_is_cut_at_any_byte_is_not_one(self):
        self.kept().append({"robot": 0, "shares": {("a", "b", "wire"): (0.5, 1000)}})
        before = self.path.stat().st_size
        self.kept().append({"robot": 1, "shares": {("a", "b", "wire"): (0.25, 1000)}})
        whole = self.path.read_bytes()
        for length in range(before, len(whole)):
            self.path.write_bytes(whole[:length])
            self.assertEqual([result["robot"] for result in self.kept().results], [0])
            self.assertEqual(self.path.stat().st_size, before)
        self.path.write_bytes(whole)
        self.assertEqual(len(self.kept().results), 2)

    def test_refuses_a_file_of_other_arguments(self):
        self.kept()
        with self.assertRaises(state.Another):
            self.kept((1, 3))
        self.path.write_bytes(b"no state")
        with self.assertRaises(state.Another):
            self.kept()

    def test_keeps_nothing_without_a_file(self):
        nothing = state.State(None, ())
        nothing.append({"robot": 0})
        self.assertEqual(nothing.results, [])


if __name__ == "__main__":
    unittest.main()
