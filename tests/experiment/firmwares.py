"""The five firmwares: what they are called, and how they are built."""

import collections
import hashlib
import json
import pathlib
import subprocess

import measure

ROOT = pathlib.Path(__file__).resolve().parents[2]
BASELINES = ROOT / "examples/finsrov/baseline"
ROBOT = ROOT / "examples/finsrov.urdf"

#: `buckets`: whether the exceptions of its schedule are its control code; else all exceptions are interruptions of it.
Firmware = collections.namedtuple("Firmware", "name title buckets")
FIRMWARES = (
    Firmware("generated", "generated", True),
    Firmware("public_polled", "polled, as public", False),
    Firmware("competent_polled", "polled, competent", False),
    Firmware("tasks_by_device", "task per device", False),
    Firmware("tasks_by_period", "task per period", False),
)
CODES = ("sram", "flash")

#: What recorded figures were made with. Debian 12's.
COMPILER = "12.2.1 20221205"


def call(*words):
    answer = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    if answer.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, words))}\n{(answer.stdout + answer.stderr)[-3000:]}")
    return answer.stdout


def compiler():
    """Version and date of the compiler for the board."""
    line = call("arm-none-eabi-g++", "--version").splitlines()[0]
    return line.split(") ", 1)[-1].strip() if ") " in line else line


class Workbench:
    """Builds images below a folder, and knows the job that `finemote run` gives the emulated board."""

    def __init__(self, finemote, folder, baselines=BASELINES):
        self.finemote, self.folder, self.baselines = pathlib.Path(finemote), pathlib.Path(folder), pathlib.Path(baselines)
        self.emulator = self.finemote.parent / "finemote-emulator"
        self.folder.mkdir(parents=True, exist_ok=True)

    def build(self, images, jobs):
        """`images`: names of targets."""
        generated, loaded, build = (self.folder / name for name in ("generated", "generated_loaded", "images"))
        call(self.finemote, "generate", ROBOT, "-o", generated)
        call(self.finemote, "generate", BASELINES / "loaded.urdf.xacro", "-o", loaded)
        words = ["cmake", "-S", BASELINES, "-B", build, "-G", "Ninja", f"-DGENERATED={generated}",
                 f"-DGENERATED_LOADED={loaded}", f"-DBASELINE_FOLDER={self.baselines}",
                 f"-DCMAKE_TOOLCHAIN_FILE={ROOT}/cmake/toolchain-arm-none-eabi.cmake"]
        call(*words)
        call("cmake", "--build", build, "-j", jobs, "--target", *images)

    def image(self, name):
        return self.folder / "images" / f"{name}.elf"

    def job(self):
        """What `finemote run` asks of the emulated board for this robot, its wiring and parts, and the hash of the bytes
        it flashed."""
        kept = self.folder / "kept"
        answer = json.loads(call(self.finemote, "run", ROBOT, "--duration", "20ms", "--keep", kept, "--format", "json"))
        job = next(kept.glob("build/*.elf.job.json"))
        return json.loads(job.read_text(encoding="utf-8")), answer["image"]["sha256"]

    def flashed(self, name):
        """Hash of the bytes that go into the flash."""
        copy = self.image(name).with_suffix(".flashed")
        call("arm-none-eabi-objcopy", "-O", "binary", self.image(name), copy)
        return hashlib.sha256(copy.read_bytes()).hexdigest()

    def analysis(self):
        """Bounds of the generated firmware, with those of what is measured."""
        chains = [word for chain in measure.CHAINS for word in ("--chain", "->".join(chain))]
        return json.loads(call(self.finemote, "analyze", ROBOT, "--format", "json", *chains))

    def run(self, name, job, stem):
        """The record of one run."""
        job = {**job, "image": str(self.image(name))}
        job_file, record_file = (self.folder / f"{stem}.{kind}.json" for kind in ("job", "record"))
        job_file.write_text(json.dumps(job), encoding="utf-8")
        call(self.emulator, job_file, record_file)
        record = json.loads(record_file.read_text(encoding="utf-8"))
        job_file.unlink()
        record_file.unlink()
        if record.get("error") or record.get("stop"):
            raise RuntimeError(f"{name}: {record.get('error') or record['stop']} {record.get('reports')}")
        return record
