"""Tests that isolaw.opensees refuses an OpenSees whose classes have another layout, with a message and without a crash.

Each case changes a few bytes in a copy of the module from PyPI and imports the copy in a process of its own.
"""

import pathlib
import shutil
import struct
import subprocess
import sys
import unittest

from devices import InFolder

try:
    import openseespylinux
except ImportError as error:
    raise unittest.SkipTest(f"skipped: {error} (tools/opensees.sh build/opensees installs it)") from None

MODULE = pathlib.Path(openseespylinux.__file__).parent / "opensees.so"


class Elf:
    """Finds symbols and relocations in a 64-bit module (an ELF file) and changes its bytes."""

    def __init__(self, file):
        self.bytes = bytearray(file.read_bytes())
        (start,) = struct.unpack_from("<Q", self.bytes, 40)
        size, count, names = struct.unpack_from("<HHH", self.bytes, 58)
        sections = [struct.unpack_from("<IIQQQQIIQQ", self.bytes, start + i * size) for i in range(count)]
        text = lambda at: bytes(self.bytes[at : self.bytes.index(0, at)]).decode()
        self.sections = {text(sections[names][4] + s[0]): s for s in sections}
        self.symbols = {}  # name -> place of its entry in the file
        offset, length = self.sections[".dynsym"][4:6]
        strings = self.sections[".dynstr"][4]
        for at in range(offset, offset + length, 24):
            (name,) = struct.unpack_from("<I", self.bytes, at)
            self.symbols[text(strings + name)] = at
        self.relocations = {}  # address that is filled when the module is loaded -> place of its entry in the file
        offset, length = self.sections[".rela.dyn"][4:6]
        for at in range(offset, offset + length, 24):
            (address,) = struct.unpack_from("<Q", self.bytes, at)
            self.relocations[address] = at

    def address(self, symbol):
        return struct.unpack_from("<Q", self.bytes, self.symbols[symbol] + 8)[0]

    def place(self, address):
        """Returns the position in the file of the byte with this address."""
        for s in self.sections.values():
            if s[3] <= address < s[3] + s[5] and s[1] != 8:
                return address - s[3] + s[4]
        raise ValueError(hex(address))

    def put(self, form, at, value):
        struct.pack_into(form, self.bytes, at, value)

    def swap(self, first, second):
        """Exchanges the values that the loader writes to two words."""
        a, b = self.relocations[first] + 8, self.relocations[second] + 8
        self.bytes[a : a + 16], self.bytes[b : b + 16] = self.bytes[b : b + 16], self.bytes[a : a + 16]


def swapped_functions(elf):
    table = elf.address("_ZTV16UniaxialMaterial")
    elf.swap(table + 8 * 10, table + 8 * 12)


def swapped_functions_of_a_section(elf):
    table = elf.address("_ZTV13Bidirectional")
    elf.swap(table + 8 * 10, table + 8 * 11)


def one_function_more(elf):
    at = elf.symbols["_ZTV16UniaxialMaterial"] + 16
    elf.put("<Q", at, struct.unpack_from("<Q", elf.bytes, at)[0] + 8)


def another_offset_to_top(elf):
    elf.put("<q", elf.place(elf.address("_ZTV16UniaxialMaterial") + 8 * 34), -24)


def another_place_of_a_base(elf):
    elf.put("<q", elf.place(elf.address("_ZTI8Material") + 8 * 6), (24 << 8) | 2)


def a_hidden_symbol(elf):
    """Hides an exported function. The module's own calls get its address instead of its name, so they still work."""
    name = "_Z23OPS_addUniaxialMaterialP16UniaxialMaterial"
    symbol = (elf.symbols[name] - elf.sections[".dynsym"][4]) // 24
    for section in (".rela.dyn", ".rela.plt"):
        offset, length = elf.sections[section][4:6]
        for at in range(offset, offset + length, 24):
            (info,) = struct.unpack_from("<Q", elf.bytes, at + 8)
            if info >> 32 == symbol:
                elf.put("<Q", at + 8, 8)  # R_X86_64_RELATIVE
                elf.put("<Q", at + 16, elf.address(name))
    (text,) = struct.unpack_from("<I", elf.bytes, elf.symbols[name])
    elf.bytes[elf.sections[".dynstr"][4] + text + 4] = ord("X")


def a_member_more(elf):
    """Makes objects look larger: code before the constructor writes 1 behind the object, at 40(%rdi)."""
    constructor, unused = elf.address("_ZN16UniaxialMaterialC2Eii"), elf.address("_Z11OPS_getTimev")
    code = b"\x48\xc7\x47\x28\x01\x00\x00\x00\xe9" + struct.pack("<i", constructor - (unused + 13))
    at = elf.place(unused)
    elf.bytes[at : at + len(code)] = code
    elf.put("<Q", elf.symbols["_ZN16UniaxialMaterialC2Eii"] + 8, unused)


def unchanged(elf):
    pass


CASES = {
    unchanged: "attached",
    swapped_functions: "UniaxialMaterial: another function stands where",
    swapped_functions_of_a_section: "SectionForceDeformation: another function stands where",
    one_function_more: "UniaxialMaterial has 47 words",
    another_offset_to_top: "UniaxialMaterial: a part of it begins at another place",
    another_place_of_a_base: "Material does not consist of",
    a_hidden_symbol: "exports no _Z23OPS_addUniaxialMaterial",
    a_member_more: "an object of UniaxialMaterial has 48 bytes instead of 32",
}

PROGRAM = """
import importlib.util, sys
sys.path[:0] = {path!r}
spec = importlib.util.spec_from_file_location("opensees", {module!r})
ops = importlib.util.module_from_spec(spec)
sys.modules["opensees"] = ops
spec.loader.exec_module(ops)
import isolaw, isolaw.opensees
try:
    isolaw.opensees.attach(ops)
    isolaw.opensees.material(1, "bilinear", {{"K1": 2.0, "K2": 1.0, "xy": 10.0}})
    print("attached")
except isolaw.Error as error:
    print(error)
"""


class Proof(InFolder):
    def test_a_doctored_module_is_refused(self):
        (self.path / "lib").symlink_to(MODULE.parent / "lib")
        for change, said in CASES.items():
            with self.subTest(change=change.__name__):
                elf = Elf(MODULE)
                change(elf)
                copy = self.path / "opensees.so"
                copy.unlink(missing_ok=True)
                copy.write_bytes(elf.bytes)
                shutil.copymode(MODULE, copy)
                done = subprocess.run(
                    [sys.executable, "-c", PROGRAM.format(path=sys.path, module=str(copy))], capture_output=True, text=True, timeout=120
                )
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn(said, done.stdout)


if __name__ == "__main__":
    unittest.main()
