#!/usr/bin/env python3
"""Makes fuzz/corpus/workbook, mat, mat73, json and the small files of text again: python3 fuzz/record_corpus.py

Each file is a tiny record. It is valid, or it has one fault that could break a reader. libmatio (libmatio-dev) writes
the files of MATLAB 7.3; this script writes all others itself.
"""
import ctypes
import ctypes.util
import io
import math
import pathlib
import struct
import zipfile
import zlib

CORPUS = pathlib.Path(__file__).parent / "corpus"
COUNT = 24
TIME = [0.1 * i for i in range(COUNT)]
DISP = [round(10 * math.sin(0.6 * i), 3) for i in range(COUNT)]
FORCE = [round(8 * math.sin(0.6 * i) + 3 * math.cos(0.6 * i), 3) for i in range(COUNT)]
NAMES = ["Time [s]", "Disp [mm]", "Force [kN]"]
# A record of two cycles that is short, so that the fuzzer runs fast on its changes.
SHORT = [(round(0.1 * i, 1), round(10 * math.sin(1.1 * i), 2), round(9 * math.sin(1.1 * i + 0.3), 2)) for i in range(13)]


def write(kind, name, data):
    (CORPUS / kind).mkdir(parents=True, exist_ok=True)
    (CORPUS / kind / name).write_bytes(data if isinstance(data, bytes) else data.encode())



def texts():
    def rows(separator=",", columns=lambda t, x, f: (t, x, f), decimal="."):
        return "".join(separator.join(str(v).replace(".", decimal) for v in columns(*row)) + "\n" for row in SHORT)

    english = "Time [s],Disp [mm],Force [kN]\n" + rows()
    for encoding in "utf-16-le", "utf-16-be", "utf-32-le", "utf-32-be":
        write("text", f"{encoding}-without-mark.csv", english.encode(encoding))
    for name, encoding, header in (("chinese", "gb18030", "时间(s),位移(mm),力(kN)"), ("korean", "cp949", "시간(s),변위(mm),수평하중(kN)"),
                                   ("japanese", "cp932", "時間(s),変位(mm),水平荷重(kN)"), ("portuguese", "cp1252", "Tempo (s),Deslocamento (mm),Força (kN)"),
                                   ("chinese-utf8", "utf-8", "时间（秒）,位移（毫米）,力（千牛）")):
        write("text", f"{name}.csv", (header + "\n" + rows()).encode(encoding))
    write("text", "russian.csv", ("Время, с;Перемещение, мм;Усилие, кН\n" + rows(";", decimal=",")).encode("cp1251"))
    write("text", "unit-factors.csv", "Time [ms],Disp [1/100 mm],Force [x10 kN]\n" + rows())
    write("text", "cycles.csv", "Cycle,Step,Time [s],Disp [mm],Force [kN]\n" + rows(columns=lambda t, x, f: (1 + int(t > 0.5), "", t, x, f)))
    write("text", "two-directions.csv", "t [s],Dx [mm],Fx [kN],Dy [mm],Fy [kN]\n" + rows(columns=lambda t, x, f: (t, x, f, 0.5 * x, 0.5 * f)))
    write("text", "missing.csv", "Time [s],Disp [mm],Force [kN]\n" + rows(columns=lambda t, x, f: (t, x, "NaN" if t == 0.5 else "" if t == 0.8 else f)))
    write("text", "stamps.csv", "Date;Time;Disp (mm);Force (kN)\n" + rows(";", lambda t, x, f: ("03.04.2024", f"10:00:0{t}", x, f), ","))
    write("text", "units-below.tsv", "t\tx\tF\ns\tmm\tkN\n" + rows("\t"))


HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n'
MAIN = 'xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"'
REL = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
PACKAGE = "http://schemas.openxmlformats.org/package/2006/relationships"


def cell(column, row, value, style=""):
    place = f"{chr(65 + column)}{row}"
    if isinstance(value, str):
        return f'<c r="{place}"{style} t="inlineStr"><is><t>{value}</t></is></c>'
    return f'<c r="{place}"{style}><v>{value}</v></c>'


def sheet_rows(first=1, names=NAMES):
    rows = [f'<row r="{first}">' + "".join(cell(c, first, n) for c, n in enumerate(names)) + "</row>"]
    for i, values in enumerate(zip(TIME, DISP, FORCE)):
        rows.append(f'<row r="{first + 1 + i}">' + "".join(cell(c, first + 1 + i, v) for c, v in enumerate(values)) + "</row>")
    return "".join(rows)


def worksheet(rows, before=""):
    return HEAD + before + f"<worksheet {MAIN}><sheetData>{rows}</sheetData></worksheet>"


def workbook(sheets, extra=(), method=zipfile.ZIP_DEFLATED):
    parts = {
        "_rels/.rels": HEAD + f'<Relationships xmlns="{PACKAGE}"><Relationship Id="r1" Type="{REL}/officeDocument" '
                              'Target="xl/workbook.xml"/></Relationships>',
        "xl/workbook.xml": HEAD + f'<workbook {MAIN} xmlns:r="{REL}"><sheets>' + "".join(
            f'<sheet name="{name}" sheetId="{i}" r:id="rId{i}"/>' for i, name in enumerate(sheets, 1)) + "</sheets></workbook>",
        "xl/_rels/workbook.xml.rels": HEAD + f'<Relationships xmlns="{PACKAGE}">' + "".join(
            f'<Relationship Id="rId{i}" Type="{REL}/worksheet" Target="worksheets/sheet{i}.xml"/>'
            for i in range(1, len(sheets) + 1)) + f'<Relationship Id="s" Type="{REL}/sharedStrings" '
            f'Target="sharedStrings.xml"/><Relationship Id="t" Type="{REL}/styles" Target="styles.xml"/></Relationships>',
    }
    for i, xml in enumerate(sheets.values(), 1):
        parts[f"xl/worksheets/sheet{i}.xml"] = xml
    parts.update(dict(extra))
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", method) as archive:
        for name, text in parts.items():
            archive.writestr(zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0)), text, compress_type=method)
    return out.getvalue()


def shared(texts):
    return HEAD + f"<sst {MAIN}>" + "".join(f"<si><t>{t}</t></si>" for t in texts) + "</sst>"


def workbooks():
    stored = zipfile.ZIP_STORED  # a fuzzer can change the text of an uncompressed file
    sound = worksheet(sheet_rows())
    write("workbook", "sound.xlsx", workbook({"Test": sound}))
    write("workbook", "stored.xlsx", workbook({"Test": sound}, method=stored))
    write("workbook", "two-sheets.xlsx", workbook({"A": sound, "B": sound}, method=stored))
    write("workbook", "repeated.xlsx", workbook({"A": worksheet(sheet_rows() + sheet_rows(40))}, method=stored))
    texts = "".join(f'<c t="s"><v>{i}</v></c>' for i in range(3))
    rows = f"<row>{texts}</row>" + "".join(
        f'<row><c s="1"><v>{t}</v></c><c t="str"><f>A1</f><v>{x}</v></c><c><f>B1</f><v>{f}</v></c></row>'
        for t, x, f in zip(TIME, DISP, FORCE))
    styles = (HEAD + f'<styleSheet {MAIN}><numFmts><numFmt numFmtId="164" formatCode="[h]:mm:ss"/></numFmts>'
              '<cellXfs><xf numFmtId="0"/><xf numFmtId="2"/><xf numFmtId="164"/></cellXfs></styleSheet>')
    extra = {"xl/sharedStrings.xml": shared(NAMES), "xl/styles.xml": styles}
    write("workbook", "shared.xlsx", workbook({"A": worksheet(rows)}, extra, stored))
    write("workbook", "dates.xlsx", workbook({"A": worksheet(rows.replace('s="1"', 's="2"'))}, extra, stored))
    write("workbook", "far-row.xlsx", workbook({"A": worksheet('<row r="1048576"><c r="A1048576"><v>1</v></c><c><v>2</v></c></row>')},
                                               method=stored))
    write("workbook", "far-cells.xlsx",
          workbook({"A": worksheet("".join(f'<row><c r="ALL{i}"><v>1</v></c></row>' for i in range(1, 200)))}, method=stored))
    write("workbook", "backwards.xlsx", workbook({"A": worksheet('<row r="5"><c r="B5"><v>1</v></c><c r="A5"><v>1</v></c></row><row r="2"/>')},
                                                 method=stored))
    entity = '<!DOCTYPE x [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;">]>'
    write("workbook", "entities.xlsx", workbook({"A": worksheet("<row><c><v>&b;</v></c></row>", entity)}, method=stored))
    write("workbook", "bomb.xlsx", workbook({"A": worksheet(" " * 3_000_000)}))
    write("workbook", "nested.xlsx", workbook({"A": worksheet("<row>" * 500)}, method=stored))
    write("workbook", "errors.xlsx", workbook({"A": worksheet(sheet_rows() + '<row><c t="e"><v>#DIV/0!</v></c><c t="b"><v>1</v></c>'
                                                              '<c><f>A1</f></c></row>')}, method=stored))
    data = bytearray(workbook({"Test": sound}))
    at = data.find(b"PK\x01\x02")
    data[at + 20:at + 28] = b"\xff\xff\xff\xff\xff\xff\xff\xff"
    write("workbook", "sizes-lie.xlsx", bytes(data))
    write("workbook", "cut.xlsx", workbook({"Test": sound})[:-200])
    write("workbook", "no-workbook.xlsx", workbook({}, {"xl/workbook.xml": ""}))
    short = "".join("<row>" + "".join(f"<c><v>{v}</v></c>" for v in row) + "</row>" for row in SHORT)
    for name, header in (("short", NAMES), ("short-chinese", ["时间 (s)", "位移 (mm)", "力 (kN)"]), ("short-factors", ["t [s]", "x [1/100 mm]", "F [x10 kN]"])):
        texts_above = "<row>" + "".join(f'<c t="inlineStr"><is><t>{t}</t></is></c>' for t in header) + "</row>"
        write("workbook", f"{name}.xlsx", workbook({"A": worksheet(texts_above + short)}, method=stored))
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as archive:
        archive.writestr(zipfile.ZipInfo("d01.csv", (1980, 1, 1, 0, 0, 0)), "1;2\n")
    write("workbook", "plain.zip", out.getvalue())



HEADER = b"MATLAB 5.0 MAT-file, made for tests".ljust(116) + bytes(8) + struct.pack("<H", 0x100) + b"IM"


def element(kind, data):
    if 0 < len(data) <= 4:
        return struct.pack("<HH", kind, len(data)) + data.ljust(4, b"\0")
    return struct.pack("<II", kind, len(data)) + data + bytes(-len(data) % 8)


def array(name, values, kind=6, columns=1, stored=9, code="d", rows=None):
    rows = len(values) // columns if rows is None else rows
    return element(14, element(6, struct.pack("<II", kind, 0)) + element(5, struct.pack("<ii", rows, columns)) +
                   element(1, name.encode()) + element(stored, struct.pack(f"<{len(values)}{code}", *values)))


def structure(name, fields, count=1, length=16):
    names = b"".join(field.encode().ljust(length, b"\0") for field, _ in fields)
    return element(14, element(6, struct.pack("<II", 2, 0)) + element(5, struct.pack("<ii", 1, count)) +
                   element(1, name.encode()) + element(5, struct.pack("<i", length)) + element(1, names) +
                   b"".join(data for _ in range(count) for _, data in fields))


def level4(name, values, columns=1, kind=0):
    """Returns a variable as MATLAB 4 wrote it. kind: 0 for doubles, 10 for floats, 20 to 50 for integers; 1000 is added
    for big-endian."""
    order = ">" if kind >= 1000 else "<"
    code = {0: "d", 10: "f", 20: "i", 30: "h", 40: "H", 50: "B"}[kind % 1000]
    return (struct.pack(f"{order}5i", kind, len(values) // columns, columns, 0, len(name) + 1) + name.encode() + b"\0" +
            struct.pack(f"{order}{len(values)}{code}", *values))


def compressed(data):
    packed = zlib.compress(data, 9)
    return struct.pack("<II", 15, len(packed)) + packed


def channels(prefix=""):
    return [(f"{prefix}{n}", array("", v)) for n, v in (("time_s", TIME), ("disp_mm", DISP), ("force_kN", FORCE))]


def matlab():
    plain = array("time_s", TIME) + array("disp_mm", DISP) + array("force_kN", FORCE)
    write("mat", "sound.mat", HEADER + plain)
    write("mat", "packed.mat", HEADER + b"".join(map(compressed, (array("time_s", TIME), array("disp_mm", DISP), array("force_kN", FORCE)))))
    write("mat", "matrix.mat", HEADER + array("x_F", TIME + DISP + FORCE, columns=3))
    write("mat", "wide.mat", HEADER + array("x_F", [v for row in zip(TIME, DISP, FORCE) for v in row], columns=COUNT, rows=3))
    write("mat", "struct.mat", HEADER + structure("test", channels()))
    write("mat", "structs.mat", HEADER + structure("test", channels(), 2) + compressed(structure("other", channels())))
    write("mat", "integers.mat", HEADER + array("disp_mm", [round(x) for x in DISP], stored=1, code="b") +
          array("force_kN", [round(x) for x in FORCE], stored=3, code="h") + array("n", [1, 2, 3], stored=2, code="B"))
    swapped = HEADER[:126] + b"MI"
    write("mat", "other-order.mat", swapped + plain)
    lying = bytearray(array("disp_mm", DISP))
    lying[36:40] = struct.pack("<i", 2**31 - 1)
    write("mat", "sizes-lie.mat", HEADER + bytes(lying) + plain)
    long = bytearray(plain)
    long[4:8] = struct.pack("<I", 0xFFFFFFFF)
    write("mat", "tag-lies.mat", HEADER + bytes(long))
    write("mat", "rank.mat", HEADER + element(14, element(6, struct.pack("<II", 6, 0)) + element(5, bytes(4000)) + element(1, b"x")))
    write("mat", "bomb.mat", HEADER + compressed(array("zeros", [0.0] * 400_000)) + plain)
    write("mat", "nested.mat", HEADER + compressed(compressed(compressed(plain))))
    deep = array("", [1.0])
    for _ in range(60):
        deep = structure("", [("a", deep)])
    write("mat", "deep.mat", HEADER + deep)
    write("mat", "many-fields.mat", HEADER + structure("s", [("a", struct.pack("<II", 14, 0))], 2000, 1))
    write("mat", "cut.mat", (HEADER + plain)[:-100])
    write("mat", "header-alone.mat", HEADER)
    time, disp, force = ([row[i] for row in SHORT] for i in range(3))
    write("mat", "short.mat", HEADER + array("time_s", time) + array("disp_mm", disp) + array("force_kN", force))
    write("mat", "level4.mat", level4("time_s", time) + level4("disp_mm", disp) + level4("force_kN", force))
    write("mat", "level4-matrix.mat", level4("x_F", time + disp + force, 3, 10))
    write("mat", "level4-big-endian.mat", level4("disp_mm", disp, kind=1000) + level4("force_kN", list(map(round, force)), kind=1030))
    matlab73()


def matlab73():
    name = ctypes.util.find_library("matio")
    if name is None:
        print("libmatio is not here: files of version 7.3 are left as they are")
        return
    matio = ctypes.CDLL(name)
    matio.Mat_CreateVer.restype = ctypes.c_void_p
    matio.Mat_VarCreate.restype = ctypes.c_void_p
    matio.Mat_VarCreateStruct.restype = ctypes.c_void_p
    double_class, double_type, version = 6, 9, 0x0200

    def variable(title, values, columns=1):
        sizes = (ctypes.c_size_t * 2)(len(values) // columns, columns)
        data = (ctypes.c_double * len(values))(*values)
        return matio.Mat_VarCreate(title.encode() if title else None, double_class, double_type, 2, sizes, data, 0)

    def save(file, variables, packing):
        path = CORPUS / "mat73" / file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.unlink(missing_ok=True)
        mat = ctypes.c_void_p(matio.Mat_CreateVer(str(path).encode(), b"MATLAB 7.3 MAT-file, made for tests", version))
        for each in variables:
            matio.Mat_VarWrite(mat, ctypes.c_void_p(each), packing)
        matio.Mat_Close(mat)
        return path

    sound = [variable("time_s", TIME), variable("disp_mm", DISP), variable("force_kN", FORCE)]
    path = save("sound.mat", sound, 0)
    save("packed.mat", [variable("x_F", TIME + DISP + FORCE, 3)] + sound, 1)
    fields = (ctypes.c_char_p * 3)(b"time_s", b"disp_mm", b"force_kN")
    sizes = (ctypes.c_size_t * 2)(1, 1)
    owner = matio.Mat_VarCreateStruct(b"test", 2, sizes, fields, 3)
    for field, values in zip(fields, (TIME, DISP, FORCE)):
        matio.Mat_VarSetStructFieldByName(ctypes.c_void_p(owner), field, ctypes.c_size_t(0), ctypes.c_void_p(variable(None, values)))
    save("struct.mat", [owner], 0)
    data = bytearray(path.read_bytes())
    for at in range(512 + 24, 512 + 96):
        data[at] ^= 0xA5
    write("mat73", "broken.mat", bytes(data))
    write("mat73", "cut.mat", path.read_bytes()[:1500])



def json_files():
    rows = ", ".join(f"[{t:.3g}, {x}, {f}]" for t, x, f in zip(TIME, DISP, FORCE))
    records = ", ".join(f'{{"time": {t:.3g}, "disp": {x}, "force": {f}}}' for t, x, f in zip(TIME, DISP, FORCE))
    arrays = f'"time_s": {TIME}, "disp": {DISP}, "force": {FORCE}'
    write("json", "arrays.json", f'{{{arrays}, "units": {{"disp": "mm"}}, "force unit": "kN"}}')
    write("json", "arrays-below.json", f'{{"a": 1, "test": {{{arrays}}}}}')
    write("json", "records.json", f"[{records}]")
    write("json", "records-below.json", f'{{"data": [{records}], "disp unit": "mm"}}')
    write("json", "rows.json", f"[{rows}]")
    write("json", "rows-below.json", f'{{"columns": ["time_s", "disp_mm", "force_kN"], "data": [{rows}]}}')
    write("json", "rows-named.json", f'[["t", "x", "F"], ["s", "mm", "kN"], {rows}]')
    write("json", "two.json", f'{{"a": [{rows}], "b": [{records}]}}')
    write("json", "ragged.json", "[[1, 2, 3], [4, 5], [6, null, \"x\"], [1, 2, 3, 4]]")
    write("json", "keys-differ.json", "[" + ", ".join(f'{{"a{i}": {i}}}' for i in range(300)) + "]")
    write("json", "deep.json", "[" * 200)
    write("json", "deep-keys.json", '{"a":' * 200)
    write("json", "mixed.json", '{"a": [1, [2, 3], {"b": 4}], "b": [[1, 2], 3, {"c": [1]}]}')
    write("json", "huge-numbers.json", '{"disp": [1e308, -1e308, 1e-400, 99999999999999999999], "force": [1, 2, 3, 1e999]}')
    write("json", "cut.json", f"[{records[:200]}")
    short = ", ".join(f"[{t}, {x}, {f}]" for t, x, f in SHORT)
    write("json", "units-list.json", f'{{"columns": ["time", "disp", "force"], "units": ["s", "mm", "kN"], "data": [{short}]}}')
    write("json", "missing.json", f'{{"columns": ["时间", "位移", "力"], "units": ["s", "1/100 mm", "x10 kN"], "rows": [[0, null, "NaN"], {short}]}}')


if __name__ == "__main__":
    texts()
    workbooks()
    matlab()
    json_files()
